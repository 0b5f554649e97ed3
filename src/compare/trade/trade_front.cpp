// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_front.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace utsuri {
namespace {

bool faster(const TradePoint& a, const TradePoint& b) {
    return std::tie(a.seconds, a.error) < std::tie(b.seconds, b.error);
}

bool less_wrong(const TradePoint& a, const TradePoint& b) {
    return std::tie(a.error, a.seconds) < std::tie(b.error, b.seconds);
}

void keep(std::optional<TradePoint>& best, const TradePoint& point,
          bool (*better)(const TradePoint&, const TradePoint&)) {
    if (!best || better(point, *best)) best = point;
}

}  // namespace

std::vector<TradePoint> trade_points(const Trade& trade, const ErrorMetric& metric, TradeTime time,
                                     TradePixels pixels) {
    const bool all = pixels == TradePixels::all;
    const Metrics& noise = all ? trade.noise : trade.noise_reflective;
    std::vector<TradePoint> points;
    for (std::size_t i = 0; i < trade.runs.size(); ++i) {
        const MethodResult& result = trade.runs[i].result;
        const double error =
            error_beyond_noise(metric, all ? result.metrics : result.metrics_reflective, noise);
        if (std::isnan(error)) continue;
        const double preparation = time == TradeTime::frame ? 0.0 : result.prepare_seconds;
        points.push_back({result.frame_seconds + preparation, error, i});
    }
    return points;
}

std::vector<TradePoint> find_front(std::vector<TradePoint> points) {
    std::stable_sort(points.begin(), points.end(), faster);
    std::vector<TradePoint> front;
    for (const TradePoint& point : points) {
        if (front.empty() || point.error < front.back().error) front.push_back(point);
    }
    return front;
}

std::optional<TradePoint> best_within(const std::vector<TradePoint>& points, double seconds) {
    std::optional<TradePoint> best;
    for (const TradePoint& point : points) {
        if (point.seconds <= seconds) keep(best, point, less_wrong);
    }
    return best;
}

std::optional<TradePoint> fastest_for(const std::vector<TradePoint>& points, double error) {
    std::optional<TradePoint> best;
    for (const TradePoint& point : points) {
        if (point.error <= error) keep(best, point, faster);
    }
    return best;
}

}  // namespace utsuri
