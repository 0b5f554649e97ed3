// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/trade.h"

#include "small_comparison.h"

namespace utsuri::test {

/// Seconds and errors of a run; every metric has the same error.
struct SmallRun {
    std::string_view reflection;
    std::vector<std::string> settings;
    std::uint32_t samples;
    double prepare_seconds;
    double frame_seconds;
    double error;
};

inline Metrics equal_metrics(double value) {
    Metrics metrics;
    metrics.mse = metrics.rel_mse = metrics.mape = metrics.flip = metrics.max = metrics.p999 = value;
    metrics.psnr = 20.0;
    metrics.ssim = 0.5;
    metrics.pixels = 12;
    return metrics;
}

inline TradeRun small_run(const SmallRun& run) {
    TradeRun made;
    made.result = small_result(run.reflection);
    made.result.image = Image();
    made.result.samples = run.samples;
    made.result.prepare_seconds = run.prepare_seconds;
    made.result.frame_seconds = run.frame_seconds;
    made.result.metrics = equal_metrics(run.error);
    made.result.metrics_reflective = equal_metrics(2.0 * run.error);
    made.options = {"--reflection", std::string(run.reflection)};
    made.options.insert(made.options.end(), run.settings.begin(), run.settings.end());
    made.picture = {std::byte{0xff}, std::byte{0xd8}, std::byte{0xff}};
    return made;
}

/// Two traced runs and three of cube maps, against a reference whose noise is 0.01 in every metric.
inline Trade small_trade() {
    Trade trade;
    trade.basis = small_comparison();
    trade.basis.methods.clear();
    trade.noise = equal_metrics(0.01);
    trade.noise_reflective = equal_metrics(0.02);
    trade.scene_options = {"rooms/hall.glb", "-o", "hall.exr", "--size", "4x3"};
    constexpr std::string_view kTrace = "trace";
    constexpr std::string_view kCube = "cube-map";
    for (const SmallRun& run :
         {SmallRun{kTrace, {}, 1, 0.0, 0.2, 0.41}, SmallRun{kTrace, {}, 2, 0.0, 0.4, 0.21},
          SmallRun{kCube, {"--map-size", "64"}, 1, 1.0, 0.02, 0.91},
          SmallRun{kCube, {"--map-size", "256"}, 1, 4.0, 0.021, 0.81},
          SmallRun{kCube, {"--map-size", "256"}, 2, 4.0, 0.04, 0.81}}) {
        trade.runs.push_back(small_run(run));
    }
    return trade;
}

}  // namespace utsuri::test
