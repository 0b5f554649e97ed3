// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/trade_front.h"

#include <array>
#include <optional>
#include <vector>

namespace utsuri {

/// Columns of the tables, in seconds and in the unit of the metric.
inline constexpr std::array kEqualSeconds = {0.01, 0.033, 0.1, 0.33, 1.0, 3.3, 10.0};
inline constexpr std::array kEqualErrors = {1.0, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001};
static_assert(kEqualErrors.size() == kEqualSeconds.size());

/// What one method makes of each column: the run it would take, or none.
struct EqualRow {
    Method method;
    std::array<std::optional<TradePoint>, kEqualSeconds.size()> cells;
};

/// The least wrong run within each of kEqualSeconds, a row for each method in the order of their first runs.
std::vector<EqualRow> equal_times(const Trade& trade, const ErrorMetric& metric, TradeTime time,
                                  TradePixels pixels = TradePixels::all);

/// The fastest run that is wrong by no more than each of kEqualErrors.
std::vector<EqualRow> equal_errors(const Trade& trade, const ErrorMetric& metric, TradeTime time,
                                   TradePixels pixels = TradePixels::all);

}  // namespace utsuri
