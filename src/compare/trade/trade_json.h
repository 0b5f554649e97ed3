// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/trade.h"

#include <nlohmann/json_fwd.hpp>

namespace utsuri {

/// Version of the layout that docs/trade-json.md describes.
inline constexpr int kTradeSchema = 1;

nlohmann::ordered_json trade_to_json(const Trade& trade);

/// As much of a trade as choosing a run takes: runs with their options, samples, times and errors, and the
/// reference's noise.
/// @throws nlohmann::json::exception if the layout is another, UsageError if it names an unknown method
Trade trade_from_json(const nlohmann::ordered_json& json);

}  // namespace utsuri
