// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_equal.h"

#include <algorithm>
#include <iterator>

namespace utsuri {
namespace {

using Columns = std::array<double, kEqualSeconds.size()>;

/// Methods in the order of their first runs.
std::vector<Method> methods_of(const Trade& trade) {
    std::vector<Method> methods;
    for (const TradeRun& run : trade.runs) {
        if (std::find(methods.begin(), methods.end(), run.result.method) == methods.end())
            methods.push_back(run.result.method);
    }
    return methods;
}

/// @param choose the point of a method for a column
std::vector<EqualRow> rows_of_methods(const Trade& trade, const std::vector<TradePoint>& all,
                                      const Columns& columns,
                                      std::optional<TradePoint> (*choose)(const std::vector<TradePoint>&,
                                                                          double)) {
    std::vector<EqualRow> rows;
    for (const Method& method : methods_of(trade)) {
        std::vector<TradePoint> points;
        std::copy_if(all.begin(), all.end(), std::back_inserter(points),
                     [&](const TradePoint& point) { return trade.runs[point.run].result.method == method; });
        EqualRow row{method, {}};
        std::transform(columns.begin(), columns.end(), row.cells.begin(),
                       [&](double column) { return choose(points, column); });
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

std::vector<EqualRow> equal_times(const Trade& trade, const ErrorMetric& metric, TradeTime time,
                                  TradePixels pixels) {
    return rows_of_methods(trade, trade_points(trade, metric, time, pixels), kEqualSeconds, best_within);
}

std::vector<EqualRow> equal_errors(const Trade& trade, const ErrorMetric& metric, TradeTime time,
                                   TradePixels pixels) {
    return rows_of_methods(trade, trade_points(trade, metric, time, pixels), kEqualErrors, fastest_for);
}

}  // namespace utsuri
