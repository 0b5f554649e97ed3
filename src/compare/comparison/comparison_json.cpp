// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/comparison_json.h"

#include "base/version.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json displacements_to_json(const DisplacementSummary& summary) {
    return {{"median", number(summary.median)}, {"p95", number(summary.p95)}};
}

Json reflection_errors_to_json(const ReflectionErrors& errors) {
    const ReflectionErrorSummary summary = summarise(errors);
    Json predicted = displacements_to_json(summary.predicted);
    predicted["image"] = errors.predicted_file;
    Json measured = displacements_to_json(summary.measured);
    measured["image"] = errors.measured_file;
    Json json = {{"pixels", summary.pixels},
                 {"seconds", errors.seconds},
                 {"predicted", std::move(predicted)},
                 {"measured", std::move(measured)},
                 {"exceeded", summary.exceeded}};
    if (!errors.traced.values.empty())
        json["traced"] = {{"pixels", summary.traced}, {"image", errors.traced_file}};
    return json;
}

Json settings_to_json(const MethodResult& result) {
    Json json = {{"samples", result.samples}};
    if (result.maps) {
        json["map_size"] = result.maps->fitted ? Json("fit") : Json(result.maps->size);
        json["map_samples"] = result.maps->samples;
        if (result.method.reflection->traits.has_polyhedron) {
            json["polyhedron"] = result.maps->polyhedron.name;
            json["faces"] = result.maps->polyhedron.planes.size();
        }
        json["most_probes"] = result.maps->most_probes;
        if (result.maps->proxy) json["proxy"] = result.maps->proxy->name;
        if (result.method.reflection->traits.has_tolerance) {
            const Tolerance& tolerance = result.maps->tolerance;
            json[tolerance.of == Tolerance::Of::radiance ? "radiance_tolerance" : "tolerance"] =
                tolerance.most;
        }
        if (result.maps->capture_point) {
            const glm::dvec3& point = *result.maps->capture_point;
            json["capture_point"] = {point.x, point.y, point.z};
        }
    }
    return json;
}

}  // namespace

Json result_to_json(const MethodResult& result) {
    return {{"name", method_name(result.method)},
            {"light", result.method.light->name},
            {"reflection", result.method.reflection->name},
            {"settings", settings_to_json(result)},
            {"prepare_seconds", result.prepare_seconds},
            {"compile_seconds", result.compile_seconds},
            {"frame_seconds", result.frame_seconds},
            {"gpu_seconds", result.gpu_seconds},
            {"peak_bytes", result.peak_bytes},
            {"rays", result.rays},
            {"prepare_rays", result.prepare_rays},
            {"maps", result.map_count},
            {"captured_maps", result.captured_maps},
            {"least_map_size", result.least_map_size},
            {"largest_map_size", result.largest_map_size},
            {"traced_fraction", result.traced_fraction},
            {"truncated_fraction", result.truncated_fraction},
            {"nonfinite", result.nonfinite},
            {"image", result.image_file}};
}

Json metrics_to_json(const Metrics& metrics) {
    return {{"mse", number(metrics.mse)},   {"rel_mse", number(metrics.rel_mse)},
            {"mape", number(metrics.mape)}, {"psnr", number(metrics.psnr)},
            {"ssim", number(metrics.ssim)}, {"flip", number(metrics.flip)},
            {"max", number(metrics.max)},   {"p999", number(metrics.p999)},
            {"pixels", metrics.pixels},     {"nonfinite", metrics.nonfinite}};
}

Json device_to_json(const DeviceSummary& device) {
    return {{"name", device.name}, {"driver", device.driver}, {"api", device.api}};
}

Json comparison_to_json(const Comparison& comparison) {
    Json reference = result_to_json(comparison.reference);
    reference["noise"] = number(comparison.reference_noise);
    reference["noise_mse"] = number(comparison.reference_noise_mse);
    Json methods = Json::array();
    for (const MethodResult& result : comparison.methods) {
        Json json = result_to_json(result);
        json["error_map"] = result.error_map_file;
        json["metrics"] = metrics_to_json(result.metrics);
        json["metrics_reflective"] = metrics_to_json(result.metrics_reflective);
        if (result.reflection_errors)
            json["reflection_errors"] = reflection_errors_to_json(*result.reflection_errors);
        methods.push_back(std::move(json));
    }
    Json failed = Json::array();
    for (const MethodFailure& failure : comparison.failures)
        failed.push_back({{"name", method_name(failure.method)}, {"message", failure.message}});
    return {{"schema", kComparisonSchema},
            {"utsuri", kVersion},
            {"scene", comparison.scene},
            {"command", comparison.command},
            {"device", device_to_json(comparison.device)},
            {"width", comparison.settings.width},
            {"height", comparison.settings.height},
            {"seed", comparison.settings.seed},
            {"specular_depth", comparison.settings.max_depth},
            {"kept_light", comparison.settings.kept_light},
            {"light_settings",
             {{"samples", comparison.light_settings.samples},
              {"spacing", comparison.light_settings.spacing},
              {"refinement", comparison.light_settings.refinement},
              {"points", comparison.light_settings.most_points}}},
            {"exposure", comparison.exposure},
            {"light", comparison.light->name},
            {"triangles", comparison.triangles},
            {"scene_bytes", comparison.scene_bytes},
            {"import_seconds", comparison.import_seconds},
            {"build_seconds", comparison.build_seconds},
            {"reflective_pixels", comparison.reflective_pixels},
            {"interrupted", comparison.interrupted},
            {"notes", comparison.notes},
            {"reference", reference},
            {"methods", methods},
            {"failed", failed}};
}

}  // namespace utsuri
