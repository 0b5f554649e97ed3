// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/error_metric.h"
#include "compare/trade/trade.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace utsuri {

/// Which time counts: that of a frame, or with what is done once before it. Compiling never counts.
enum class TradeTime { frame, with_preparation };
/// Which pixels count: all, or those whose first hit is reflective.
enum class TradePixels { all, reflective };

/// A run as a point.
struct TradePoint {
    double seconds = 0.0;
    double error = 0.0;   ///< beyond the reference's noise: error_beyond_noise()
    std::size_t run = 0;  ///< its index

    friend bool operator==(const TradePoint&, const TradePoint&) = default;
};

/// All runs that have an error, in their order.
std::vector<TradePoint> trade_points(const Trade& trade, const ErrorMetric& metric, TradeTime time,
                                     TradePixels pixels = TradePixels::all);

/// The points that none beats: no other is as fast and less wrong, or faster and no more wrong. Ascending in
/// time; of equal points the first.
std::vector<TradePoint> find_front(std::vector<TradePoint> points);

/// The least wrong point that takes at most `seconds`, of several the fastest.
std::optional<TradePoint> best_within(const std::vector<TradePoint>& points, double seconds);

/// The fastest point that is wrong by at most `error`, of several the least wrong.
std::optional<TradePoint> fastest_for(const std::vector<TradePoint>& points, double error);

}  // namespace utsuri
