// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/map_capture.h"

#include "base/stopwatch.h"

#include "interop/frame.h"

#include <algorithm>

namespace utsuri {

MapCapture::MapCapture(Device& device, const GpuScene& scene, const SurfaceLight& light, ReflectionMaps& maps,
                       const RenderSettings& settings, const MapSettings& map_settings)
    : device_(device),
      scene_(scene),
      light_(light),
      maps_(maps),
      settings_(settings),
      samples_(map_settings.samples),
      captures_all_(map_settings.captures_all) {}

void MapCapture::prepare(const Camera& eye, RenderStatistics& statistics) {
    statistics.maps = maps_.map_count();
    statistics.captured_maps = maps_.captured_count();
    statistics.least_map_size = maps_.least_size();
    statistics.largest_map_size = maps_.largest_size();
    if (statistics.maps == 0) return;
    const Stopwatch stopwatch;
    maps_.orient_to(eye);
    tracer_.emplace(
        device_, scene_, light_,
        maps_.kind() == MapKind::sphere ? interop::PROJECTION_SPHERE_MAP : interop::PROJECTION_PERSPECTIVE);
    tracer_->warm_up(film_of(maps_.stride(0)), maps_.texels());
    statistics.compile_seconds += stopwatch.seconds();
    if (captures_all_) maps_.want_all();
}

bool MapCapture::capture_missing(RenderStatistics& statistics, Progress& progress) {
    if (!tracer_) return false;
    const std::vector<std::uint32_t> wanted = maps_.wanted();
    if (wanted.empty()) return false;
    std::vector<std::uint32_t> done;
    for (const std::uint32_t map : wanted) {
        if (progress.cancelled()) break;
        accumulate(statistics.prepare_counts, capture(map));
        done.push_back(map);
        progress.update(static_cast<double>(done.size()), static_cast<double>(wanted.size()));
    }
    film_.reset();
    maps_.mark_captured(done);
    statistics.captured_maps = maps_.captured_count();
    return true;
}

Film& MapCapture::film_of(std::uint32_t edge) {
    if (!film_ || film_->width() != edge) {
        film_.reset();
        film_.emplace(device_, edge, edge, "map film");
    }
    return *film_;
}

FrameCounts MapCapture::capture(std::uint32_t map) {
    const std::uint32_t probe = map / maps_.maps_per_probe();
    FrameSettings frame;
    frame.camera = maps_.map_camera(map);
    // The factor is odd, so that different maps get different seeds; no map gets the picture's.
    frame.seed = settings_.seed ^ (0x9e3779b9u * (map + 1));
    frame.max_depth = std::min(settings_.max_depth, scene_.max_depth());
    frame.excluded_instance = maps_.reflectors().instances[maps_.probes()[probe].reflector];
    return tracer_->trace(film_of(maps_.stride(probe)), frame, samples_, maps_.texels(),
                          maps_.first_texel(map));
}

}  // namespace utsuri
