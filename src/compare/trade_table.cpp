// SPDX-License-Identifier: Apache-2.0
#include "compare/trade_table.h"

#include "compare/comparison_table.h"
#include "compare/trade_front.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

namespace utsuri {
namespace {

constexpr std::array kEqualSeconds = {0.01, 0.033, 0.1, 0.33, 1.0, 3.3, 10.0};
constexpr std::array kEqualErrors = {1.0, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001};
constexpr std::size_t kColumns = kEqualSeconds.size();
static_assert(kEqualErrors.size() == kColumns);

constexpr const char* kFrontRow = "{:>10}{:>11}{:>10}{:>11}  {:<19}{}\n";

std::string front_rows(const Trade& trade, const ErrorMetric& metric, TradeTime time) {
    std::string text =
        fmt::format(kFrontRow, "frame", "prepare", metric.title, "memory", "method", "settings");
    for (const TradePoint& point : find_front(trade_points(trade, metric, time))) {
        const TradeRun& run = trade.runs[point.run];
        text += fmt::format(
            kFrontRow, format_seconds(run.result.frame_seconds), format_seconds(run.result.prepare_seconds),
            format_error(metric, point.error, trade.noise), format_bytes(run.result.peak_bytes),
            method_name(run.result.method), settings_text(run));
    }
    return text;
}

/// Methods in the order of their first runs.
std::vector<Method> methods_of(const Trade& trade) {
    std::vector<Method> methods;
    for (const TradeRun& run : trade.runs) {
        if (std::find(methods.begin(), methods.end(), run.result.method) == methods.end())
            methods.push_back(run.result.method);
    }
    return methods;
}

/// A row for each method and one for the best of all; a cell from the method's points and the column.
std::string rows_of_methods(
    const Trade& trade, const ErrorMetric& metric, const std::array<std::string, kColumns>& heads,
    const std::function<std::string(const std::vector<TradePoint>&, std::size_t)>& cell) {
    const std::vector<TradePoint> all = trade_points(trade, metric, TradeTime::frame);
    const auto row = [&](const std::string& name, const std::vector<TradePoint>& points) {
        std::string line = fmt::format("{:<20}", name);
        for (std::size_t i = 0; i < kColumns; ++i)
            line += fmt::format("{:>11}", cell(points, i));
        return line + "\n";
    };
    std::string text = fmt::format("{:<20}", "");
    for (const std::string& head : heads)
        text += fmt::format("{:>11}", head);
    text += "\n";
    for (const Method& method : methods_of(trade)) {
        std::vector<TradePoint> points;
        std::copy_if(all.begin(), all.end(), std::back_inserter(points),
                     [&](const TradePoint& point) { return trade.runs[point.run].result.method == method; });
        text += row(method_name(method), points);
    }
    return text;
}

std::string equal_time_rows(const Trade& trade, const ErrorMetric& metric) {
    std::array<std::string, kColumns> heads;
    std::transform(kEqualSeconds.begin(), kEqualSeconds.end(), heads.begin(), format_seconds);
    return rows_of_methods(trade, metric, heads,
                           [&](const std::vector<TradePoint>& points, std::size_t column) {
                               const auto best = best_within(points, kEqualSeconds[column]);
                               return best ? format_error(metric, best->error, trade.noise) : "-";
                           });
}

std::string equal_error_rows(const Trade& trade, const ErrorMetric& metric) {
    std::array<std::string, kColumns> heads;
    std::transform(kEqualErrors.begin(), kEqualErrors.end(), heads.begin(),
                   [](double error) { return fmt::format("{:g}", error); });
    return rows_of_methods(trade, metric, heads,
                           [&](const std::vector<TradePoint>& points, std::size_t column) {
                               const auto fastest = fastest_for(points, kEqualErrors[column]);
                               return fastest ? format_seconds(fastest->seconds) : "-";
                           });
}

}  // namespace

std::string format_error(const ErrorMetric& metric, double error, const Metrics& noise) {
    const bool hidden = error <= least_error(metric, noise) && error > 0.0;
    return fmt::format("{}{:.3g}", hidden ? "<" : "", error);
}

std::string trade_table(const Trade& trade, const ErrorMetric& metric) {
    const Comparison& basis = trade.basis;
    const double least = least_error(metric, trade.noise);
    std::string text =
        fmt::format("{} on {} ({})\n{} triangles, {} x {} pixels, {} of them reflective; {} runs\n",
                    basis.scene, basis.device.name, basis.device.driver, basis.triangles,
                    basis.settings.width, basis.settings.height, basis.reflective_pixels, trade.runs.size());
    text += fmt::format(
        "Errors are {} against {} samples per pixel of {}{}.\nNone below {:.3g} is told from the noise of "
        "the reference: such runs rank alike, and are marked <.\n",
        metric.title, basis.reference.samples, method_name(basis.reference.method),
        metric.adds_noise ? ", whose noise is subtracted" : "", least);
    text += "\nnothing beats these, by the time of a frame\n" + front_rows(trade, metric, TradeTime::frame);
    text += "\nnothing beats these, by the time of preparation and a frame\n" +
            front_rows(trade, metric, TradeTime::with_preparation);
    text += fmt::format("\n{} at equal times of a frame\n", metric.title) + equal_time_rows(trade, metric);
    text += fmt::format("\ntime of a frame at equal {}\n", metric.title) + equal_error_rows(trade, metric);
    for (const TradeFailure& failure : trade.failures)
        text += fmt::format("\n{} is missing: {}\n", fmt::join(failure.options, " "), failure.message);
    return text;
}

}  // namespace utsuri
