// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include <cstddef>
#include <string>
#include <vector>

namespace utsuri {

/// A method with settings of its own.
struct TradeSetting {
    Method method;
    MapSettings maps;
    std::vector<std::string> options;  ///< words of `utsuri render` that choose it
};

/// A setting at a number of samples per pixel: one point of error against time.
struct TradeRun {
    MethodResult result;               ///< without its pictures
    std::vector<std::string> options;  ///< of its setting
    std::vector<std::byte> picture;    ///< JPEG; empty in a trade that was kept
};

/// A setting that could not be carried out here, or samples that the reference could not be given.
struct TradeFailure {
    Method method;
    std::vector<std::string> options;  ///< of the setting, or what is missing
    std::string message;
    ExitCode exit_code = ExitCode::device;
};

/// What time buys: methods over their settings, held against one reference.
struct Trade {
    Comparison basis;  ///< the reference and what all runs share; no methods
    std::vector<std::string>
        scene_options;  ///< words of `utsuri render` that all runs share, the scene first
    Metrics noise;  ///< of the reference's half against its whole: what its noise alone shows in each metric
    Metrics noise_reflective;  ///< over pixels whose first hit is reflective
    std::vector<TradeRun> runs;
    std::vector<TradeFailure> failures;
    bool interrupted = false;  ///< some runs are missing

    [[nodiscard]] std::vector<std::string> render_command(const TradeRun& run) const;
};

/// "--map-size 256 --spp 4": what sets a run apart from others of its method.
std::string settings_text(const TradeRun& run);

}  // namespace utsuri
