// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

namespace utsuri::test {

/// Values of metrics that no formula gives, each its own, so that mixed-up columns show.
inline Metrics distinct_metrics(double base) {
    Metrics metrics;
    metrics.mse = base + 0.1;
    metrics.rel_mse = base + 0.2;
    metrics.mape = base + 0.3;
    metrics.psnr = base + 0.4;
    metrics.ssim = base + 0.5;
    metrics.flip = base + 0.6;
    metrics.max = base + 0.7;
    metrics.p999 = base + 0.8;
    metrics.pixels = 12;
    metrics.nonfinite = 1;
    return metrics;
}

inline MethodResult small_result(std::string_view reflection) {
    MethodResult result;
    result.method = find_method("direct", reflection);
    result.samples = 4;
    if (result.method.reflection->traits.looks_up_maps) result.maps = MapSettings{};
    result.prepare_seconds = 0.25;
    result.compile_seconds = 0.5;
    result.frame_seconds = 2.0;
    result.gpu_seconds = 1.5;
    result.peak_bytes = 3 << 20;
    result.rays = 12345678;
    result.prepare_rays = 99;
    result.map_count = 12;
    result.captured_maps = 5;
    result.traced_fraction = reflection == "trace" ? 1.0 : 0.0;
    result.nonfinite = 7;
    result.truncated_fraction = 0.125;
    result.image = Image(4, 3);
    result.image_file = "picture.exr";
    result.error_map_file = "error.png";
    result.metrics = distinct_metrics(10.0);
    result.metrics_reflective = distinct_metrics(20.0);
    return result;
}

/// All methods on 4 x 3 pixels, 2 of them reflective.
inline Comparison small_comparison() {
    Comparison comparison;
    comparison.scene = "rooms/hall.glb";
    comparison.command = "utsuri compare rooms/hall.glb";
    comparison.device.name = "a device";
    comparison.device.driver = "a driver 1.2";
    comparison.device.api = "1.3.230";
    comparison.settings.width = 4;
    comparison.settings.height = 3;
    comparison.settings.seed = 5;
    comparison.settings.max_depth = 6;
    comparison.exposure = -1.5;
    comparison.import_seconds = 0.75;
    comparison.build_seconds = 0.0625;
    comparison.scene_bytes = 4096;
    comparison.triangles = 38;
    comparison.reference = small_result("trace");
    comparison.reference.samples = 96;
    comparison.reference.image_file = "reference.exr";
    comparison.reference.error_map_file.clear();
    comparison.reference_noise = 0.03;
    comparison.reference_noise_mse = 0.0009;
    for (const Method& method : all_methods(light_methods().front())) {
        comparison.methods.push_back(small_result(method.reflection->name));
    }
    comparison.reflective_pixels = 2;
    comparison.notes = {"one note", "another \"note\""};
    return comparison;
}

}  // namespace utsuri::test
