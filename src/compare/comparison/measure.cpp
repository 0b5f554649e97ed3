// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/measure.h"

#include <utility>

namespace utsuri {
namespace {

double fraction(std::uint64_t part, std::uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

}  // namespace

MethodResult collect_result(const PictureSettings& settings, const Picture& picture,
                            const MemoryUsage& memory) {
    const RenderStatistics& statistics = picture.statistics();
    MethodResult result;
    result.method = settings.method;
    result.samples = picture.samples();
    if (settings.method.reflection->traits.looks_up_maps) result.maps = settings.maps;
    result.prepare_seconds = statistics.prepare_seconds;
    result.compile_seconds = statistics.compile_seconds;
    result.frame_seconds = statistics.frame_seconds;
    result.gpu_seconds = statistics.counts.gpu_seconds;
    result.peak_bytes = memory.peak;
    result.rays = statistics.counts.rays;
    result.prepare_rays = statistics.prepare_counts.rays;
    result.map_count = statistics.maps;
    result.captured_maps = statistics.captured_maps;
    result.least_map_size = statistics.least_map_size;
    result.largest_map_size = statistics.largest_map_size;
    result.traced_fraction = fraction(statistics.counts.traced, statistics.counts.lookups);
    result.nonfinite = statistics.counts.nonfinite + statistics.prepare_counts.nonfinite;
    result.truncated_fraction = fraction(statistics.counts.truncated, statistics.counts.lookups);
    result.image = picture.image();
    return result;
}

void measure_errors(const Comparison& comparison, MethodResult& result) {
    MetricSettings settings;
    settings.exposure = comparison.exposure;
    const Image& reference = comparison.reference.image;
    PerceptualMaps maps = compute_perceptual_maps(reference, result.image, settings);
    result.metrics = compute_metrics(reference, result.image, &maps, nullptr, settings);
    result.metrics_reflective =
        compute_metrics(reference, result.image, &maps, &comparison.reflective, settings);
    result.flip = std::move(maps.flip);
}

}  // namespace utsuri
