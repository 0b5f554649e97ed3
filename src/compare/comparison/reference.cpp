// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/reference.h"

#include "compare/comparison/comparison_table.h"
#include "compare/comparison/measure.h"

#include "image/tone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace utsuri {
namespace {

/// Where the noise hides all that methods are off, this many times as many samples are tried.
constexpr double kMoreSamples = 4.0;
constexpr std::uint32_t kMostSamples = 1u << 24;

std::uint32_t even(double samples) {
    const double most = std::min(std::ceil(samples), static_cast<double>(kMostSamples));
    const auto whole = static_cast<std::uint32_t>(most);
    return whole + whole % 2;
}

PictureSettings reference_settings(const Camera& camera, const ComparisonSettings& settings) {
    // It has samples of its own: with the methods' seed its errors would be theirs.
    RenderSettings render = settings.render;
    render.seed = ~settings.render.seed;
    // Exact wherever it goes.
    const Method method{settings.light, &find_reflection("trace")};
    return {method, camera, render, settings.maps, fmt::format("reference {}", method_name(method))};
}

}  // namespace

Reference::Reference(Session& session, const Camera& camera, const ComparisonSettings& settings)
    : session_(session),
      settings_(settings),
      picture_settings_(reference_settings(camera, settings)),
      picture_(session.make_picture(picture_settings_)) {}

std::uint32_t Reference::affordable(std::uint32_t wanted) const {
    const double spent = picture_.statistics().frame_seconds;
    if (settings_.reference_samples || samples() == 0) return wanted;
    const double left = std::max(settings_.reference_seconds - spent, 0.0);
    const double more = left / (spent / samples());
    return std::min(wanted, samples() + even(std::max(more - 1.0, 0.0)));
}

bool Reference::grow(std::uint32_t wanted, Progress& progress) {
    const std::uint32_t before = samples();
    if (before == 0) {
        session_.reset_peak_memory();
        picture_.prepare(progress);
    }
    // Two of them tell how long the others take.
    for (const std::uint32_t step : {std::min(wanted, std::max(before, 2u)), wanted}) {
        const std::uint32_t target = affordable(step);
        if (target <= samples() || progress.cancelled()) continue;
        const double seconds = samples() == 0 ? 0.0
                                              : picture_.statistics().frame_seconds / samples() *
                                                    static_cast<double>(target - samples());
        progress.begin(fmt::format("{}, {} samples per pixel{}", picture_settings_.title, target,
                                   seconds > 0.0 ? ", about " + format_seconds(seconds) : ""));
        picture_.add_samples(target - samples(), progress);
    }
    // Later the peak is what methods took beside it.
    if (before == 0) memory_ = session_.memory();
    return samples() > before;
}

void Reference::tell(Comparison& comparison) const {
    if (samples() == 0) throw Interrupted();
    comparison.reference = collect_result(picture_settings_, picture_, memory_);
    comparison.reference.image_file = "reference.exr";
    comparison.reference_half = picture_.half_image(0);
    const double scale = normalisation(comparison.reference.image);
    std::optional<NoiseEstimate> noise;
    if (samples() % 2 == 0) noise = picture_.noise();
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    comparison.reference_noise = noise ? noise->relative : kUnknown;
    comparison.reference_noise_mse = noise ? noise->mse * scale * scale : kUnknown;
    comparison.exposure = settings_.exposure.value_or(auto_exposure(comparison.reference.image));
}

std::uint32_t first_reference_samples(const ComparisonSettings& settings) {
    if (settings.reference_samples) return *settings.reference_samples;
    return even(settings.samples / kReferenceShare);
}

std::uint32_t needed_reference_samples(const Comparison& comparison, double least_error) {
    const double noise = comparison.reference_noise_mse;
    const std::uint32_t samples = comparison.reference.samples;
    if (std::isnan(noise) || std::isinf(least_error) || noise <= kReferenceShare * least_error)
        return samples;
    // What is reported is the method's own error and the noise, which falls as samples grow.
    const double own = least_error - noise;
    const double times = own > 0.0 ? std::min((1.0 - kReferenceShare) / kReferenceShare * noise / own,
                                              kMoreSamples * kMoreSamples)
                                   : kMoreSamples;
    return even(samples * std::max(times, 1.0) + 2.0);
}

std::vector<Method> methods_near_noise(const Comparison& comparison) {
    std::vector<Method> near;
    for (const MethodResult& result : comparison.methods) {
        if (comparison.reference_noise_mse > kReferenceShare * result.metrics.mse)
            near.push_back(result.method);
    }
    return near;
}

}  // namespace utsuri
