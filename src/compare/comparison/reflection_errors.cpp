// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/reflection_errors.h"

#include "base/check.h"
#include "base/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

namespace utsuri {
namespace {

constexpr double kTail = 0.95;

template <typename Errors>
Plane displacements(const std::vector<Errors>& errors, const RenderSettings& settings) {
    Plane plane(settings.width, settings.height);
    std::transform(errors.begin(), errors.end(), plane.values.begin(),
                   [](const Errors& error) { return error.pixels; });
    return plane;
}

/// The least value that at least this share of all do not exceed (the nearest rank).
double quantile(std::vector<float> values, double share) {
    if (values.empty()) return 0.0;
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto place = values.begin() + std::max(std::ptrdiff_t{0}, static_cast<std::ptrdiff_t>(rank) - 1);
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
}

DisplacementSummary summary_of(const Plane& plane) {
    std::vector<float> seen;
    std::copy_if(plane.values.begin(), plane.values.end(), std::back_inserter(seen),
                 [](float value) { return value >= 0.0f; });
    return {quantile(seen, 0.5), quantile(seen, kTail)};
}

}  // namespace

ReflectionErrors find_reflection_errors(Session& session, PictureSettings settings, Progress& progress) {
    const ReflectionTraits& traits = settings.method.reflection->traits;
    UTSURI_CHECK(traits.predicts_errors);
    const Stopwatch stopwatch;
    settings.maps.predicts_errors = true;
    settings.maps.samples = 1;  // errors are of places, whatever their colours
    Picture picture = session.make_picture(settings);
    picture.prepare(progress);
    ReflectionErrors errors;
    errors.predicted = displacements(picture.predict_errors(), settings.render);
    errors.measured = displacements(picture.measure_errors(), settings.render);
    if (traits.has_tolerance) {
        errors.traced = Plane(settings.render.width, settings.render.height);
        errors.traced.values = picture.traced_pixels();
        for (std::size_t i = 0; i < errors.traced.values.size(); ++i) {
            if (errors.traced.values[i] <= 0.0f) continue;
            errors.predicted.values[i] = errors.measured.values[i] = 0.0f;
        }
    }
    errors.seconds = stopwatch.seconds();
    return errors;
}

ReflectionErrorSummary summarise(const ReflectionErrors& errors) {
    ReflectionErrorSummary summary;
    std::uint64_t exceeded = 0;
    for (std::size_t i = 0; i < errors.predicted.values.size(); ++i) {
        if (errors.predicted.values[i] < 0.0f) continue;
        ++summary.pixels;
        exceeded += errors.measured.values[i] > errors.predicted.values[i] ? 1 : 0;
    }
    summary.traced =
        static_cast<std::uint64_t>(std::count_if(errors.traced.values.begin(), errors.traced.values.end(),
                                                 [](float traced) { return traced > 0.0f; }));
    summary.predicted = summary_of(errors.predicted);
    summary.measured = summary_of(errors.measured);
    if (summary.pixels > 0)
        summary.exceeded = static_cast<double>(exceeded) / static_cast<double>(summary.pixels);
    return summary;
}

}  // namespace utsuri
