// SPDX-License-Identifier: Apache-2.0
#include "compare/run_comparison.h"

#include "compare/measure.h"
#include "renderers/film/aov.h"
#include "renderers/film/frame_camera.h"

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

Rendered render(const RenderInput& input, const Method& method, const RenderSettings& settings,
                const MapSettings& maps, std::uint32_t samples, const std::string& title,
                Progress& progress) {
    input.device.reset_peak_memory();
    const std::unique_ptr<Renderer> renderer = make_renderer(method, input, settings, maps);
    if (uses_maps(method)) progress.begin(fmt::format("{}, capturing maps", title));
    renderer->prepare(progress);
    Film film(input.device, settings.width, settings.height, title);
    progress.begin(fmt::format("{}, {} samples per pixel", title, samples));
    renderer->add_samples(film, samples, progress);

    Rendered rendered;
    if (film.samples() >= 2 && film.samples() % 2 == 0) rendered.noise = film.estimate_noise();
    rendered.half = film.resolve_half(0);
    rendered.result = collect_result(method, maps, *renderer, film, input.device);
    return rendered;
}

/// After all methods have been timed, so that drivers do not know a method's pipelines from predictions.
void add_reflection_errors(Comparison& comparison, const RenderInput& input,
                           const ComparisonSettings& settings, Progress& progress) {
    for (MethodResult& result : comparison.methods) {
        if (progress.cancelled()) return;
        if (!tells_errors(result.method)) continue;
        progress.begin(fmt::format("{}, predicting errors", method_name(result.method)));
        try {
            ReflectionErrors errors =
                find_reflection_errors(result.method, input, settings.render, settings.maps, progress);
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

Comparison run_comparison(const RenderInput& input, const ComparisonSettings& settings, Progress& progress) {
    Comparison comparison;
    comparison.device = input.device.summary();
    comparison.settings = settings.render;
    comparison.light = settings.light;
    comparison.build_seconds = input.data.build_seconds;
    comparison.scene_bytes = input.data.device_bytes();
    comparison.triangles = input.data.requirements.triangles;
    const auto camera =
        make_camera_info(input.camera, input.data.origin, settings.render.width, settings.render.height);
    comparison.reflective = reflective_mask(
        render_aovs(input.device, input.scene, camera, settings.render.width, settings.render.height));
    comparison.reflective_pixels =
        static_cast<std::uint64_t>(std::count(comparison.reflective.begin(), comparison.reflective.end(), 1));

    // The reference has samples of its own: with the methods' seed its errors would be theirs.
    RenderSettings reference_settings = settings.render;
    reference_settings.seed = ~settings.render.seed;
    Rendered reference =
        render(input, {settings.light, ReflectionMethod::trace}, reference_settings, settings.maps,
               settings.reference_samples, "reference direct/trace", progress);
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
            MethodResult result = render(input, method, settings.render, settings.maps, settings.samples,
                                         method_name(method), progress)
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
    if (settings.predictions) add_reflection_errors(comparison, input, settings, progress);
    comparison.interrupted = progress.cancelled();
    return comparison;
}

}  // namespace utsuri
