// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/run_comparison.h"

#include "compare/comparison/measure.h"
#include "renderers/film/aov.h"

#include "image/tone.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace utsuri {
namespace {

std::string file_stem(const Method& method) {
    std::string name = method_name(method);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

struct Rendered {
    MethodResult result;
    std::optional<NoiseEstimate> noise;
    Image half;
};

Rendered render(Session& session, const PictureSettings& settings, std::uint32_t samples,
                Progress& progress) {
    session.reset_peak_memory();
    Picture picture = session.make_picture(settings);
    if (settings.method.reflection->traits.looks_up_maps)
        progress.begin(fmt::format("{}, capturing maps", settings.title));
    picture.prepare(progress);
    progress.begin(fmt::format("{}, {} samples per pixel", settings.title, samples));
    picture.add_samples(samples, progress);

    Rendered rendered;
    if (picture.samples() >= 2 && picture.samples() % 2 == 0) rendered.noise = picture.noise();
    rendered.half = picture.half_image(0);
    rendered.result = collect_result(settings, picture, session.memory());
    return rendered;
}

/// Exact wherever it goes.
const ReflectionMethod& reference_reflection() {
    return find_reflection("trace");
}

/// After all methods have been timed, so that drivers do not know a method's pipelines from predictions.
void add_reflection_errors(Comparison& comparison, Session& session, const Camera& camera,
                           const ComparisonSettings& settings, Progress& progress) {
    for (MethodResult& result : comparison.methods) {
        if (progress.cancelled()) return;
        if (!result.method.reflection->traits.predicts_errors) continue;
        progress.begin(fmt::format("{}, predicting errors", method_name(result.method)));
        try {
            ReflectionErrors errors = find_reflection_errors(
                session, {result.method, camera, settings.render, settings.maps}, progress);
            const std::string stem = file_stem(result.method);
            errors.predicted_file = stem + "_predicted.png";
            errors.measured_file = stem + "_measured.png";
            if (!errors.traced.values.empty()) errors.traced_file = stem + "_traced.png";
            result.reflection_errors = std::move(errors);
        } catch (const Interrupted&) {
            return;
        } catch (const Error& error) {
            comparison.failures.push_back(
                {result.method, fmt::format("predictions: {}", error.what()), error.exit_code()});
        }
    }
}

}  // namespace

Comparison run_comparison(Session& session, const Camera& camera, const ComparisonSettings& settings,
                          Progress& progress) {
    Comparison comparison;
    comparison.device = session.device();
    comparison.settings = settings.render;
    comparison.light = settings.light;
    comparison.build_seconds = session.scene().build_seconds;
    comparison.scene_bytes = session.scene().device_bytes();
    comparison.triangles = session.scene().requirements.triangles;
    comparison.reflective =
        reflective_mask(session.first_hits(camera, settings.render.width, settings.render.height));
    comparison.reflective_pixels =
        static_cast<std::uint64_t>(std::count(comparison.reflective.begin(), comparison.reflective.end(), 1));

    // The reference has samples of its own: with the methods' seed its errors would be theirs.
    RenderSettings reference_settings = settings.render;
    reference_settings.seed = ~settings.render.seed;
    const Method reference_method{settings.light, &reference_reflection()};
    Rendered reference = render(session,
                                {reference_method, camera, reference_settings, settings.maps,
                                 fmt::format("reference {}", method_name(reference_method))},
                                settings.reference_samples, progress);
    if (reference.result.samples == 0) throw Interrupted();
    comparison.reference = std::move(reference.result);
    comparison.reference_half = std::move(reference.half);
    comparison.reference.image_file = "reference.exr";
    const double scale = normalisation(comparison.reference.image);
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    comparison.reference_noise = reference.noise ? reference.noise->relative : kUnknown;
    comparison.reference_noise_mse = reference.noise ? reference.noise->mse * scale * scale : kUnknown;
    comparison.exposure = settings.exposure.value_or(auto_exposure(comparison.reference.image));

    for (const Method& method : settings.methods) {
        if (progress.cancelled()) break;
        try {
            MethodResult result =
                render(session, {method, camera, settings.render, settings.maps, method_name(method)},
                       settings.samples, progress)
                    .result;
            if (result.samples == 0) break;
            progress.begin(fmt::format("{}, measuring", method_name(method)));
            measure_errors(comparison, result);
            result.image_file = file_stem(method) + ".exr";
            result.error_map_file = file_stem(method) + "_flip.png";
            comparison.methods.push_back(std::move(result));
        } catch (const Interrupted&) {
            break;
        } catch (const Error& error) {
            // What other methods took minutes for is not lost with this one.
            comparison.failures.push_back({method, error.what(), error.exit_code()});
        }
    }
    if (settings.predictions) add_reflection_errors(comparison, session, camera, settings, progress);
    comparison.interrupted = progress.cancelled();
    return comparison;
}

}  // namespace utsuri
