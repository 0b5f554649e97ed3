// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/run_comparison.h"

#include "compare/comparison/measure.h"
#include "compare/comparison/reference.h"
#include "renderers/film/aov.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace utsuri {
namespace {

std::string file_stem(const Method& method) {
    std::string name = method_name(method);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

Picture render(Session& session, const PictureSettings& settings, std::uint32_t samples, Progress& progress) {
    session.reset_peak_memory();
    Picture picture = session.make_picture(settings);
    if (settings.method.reflection->traits.looks_up_maps)
        progress.begin(fmt::format("{}, capturing maps", settings.title));
    picture.prepare(progress);
    progress.begin(fmt::format("{}, {} samples per pixel", settings.title, samples));
    picture.add_samples(samples, progress);
    return picture;
}

/// @param held_bytes of device memory that are not the method's
MethodResult render_method(Session& session, const Camera& camera, const Method& method,
                           const ComparisonSettings& settings, std::uint64_t held_bytes, Progress& progress) {
    const PictureSettings picture_settings{method, camera, settings.render, settings.maps,
                                           method_name(method)};
    const Picture picture = render(session, picture_settings, settings.samples, progress);
    MemoryUsage memory = session.memory();
    memory.peak -= held_bytes;
    return collect_result(picture_settings, picture, memory);
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

double least_error(const Comparison& comparison) {
    double least = std::numeric_limits<double>::infinity();
    for (const MethodResult& result : comparison.methods)
        least = std::min(least, result.metrics.mse);
    return least;
}

/// Adds samples to the reference until it is right enough for all methods, or its time is over, and measures
/// them again. If that fails the reference stays as it was told.
void refine_reference(Comparison& comparison, Reference& reference, Progress& progress) try {
    while (!progress.cancelled() &&
           reference.grow(needed_reference_samples(comparison, least_error(comparison)), progress)) {
        reference.tell(comparison);
        for (MethodResult& result : comparison.methods) {
            progress.begin(fmt::format("{}, measuring", method_name(result.method)));
            measure_errors(comparison, result);
        }
    }
} catch (const Error& error) {
    comparison.failures.push_back(
        {comparison.reference.method, fmt::format("reference: {}", error.what()), error.exit_code()});
}

}  // namespace

Comparison begin_comparison(Session& session, const Camera& camera, const ComparisonSettings& settings) {
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
    return comparison;
}

Comparison run_comparison(Session& session, const Camera& camera, const ComparisonSettings& settings,
                          Progress& progress) {
    Comparison comparison = begin_comparison(session, camera, settings);
    Reference reference(session, camera, settings);
    reference.grow(first_reference_samples(settings), progress);
    reference.tell(comparison);
    for (const Method& method : settings.methods) {
        if (progress.cancelled()) break;
        try {
            MethodResult result =
                render_method(session, camera, method, settings, reference.held_bytes(), progress);
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
    if (!settings.reference_samples) refine_reference(comparison, reference, progress);
    if (settings.predictions) add_reflection_errors(comparison, session, camera, settings, progress);
    comparison.interrupted = progress.cancelled();
    return comparison;
}

}  // namespace utsuri
