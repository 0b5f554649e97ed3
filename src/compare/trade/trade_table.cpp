// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_table.h"

#include "compare/comparison/comparison_table.h"
#include "compare/trade/trade_equal.h"
#include "compare/trade/trade_front.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace utsuri {
namespace {

constexpr const char* kFrontRow = "{:>10}{:>11}{:>10}{:>11}  {:<21}{}\n";

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

/// A line with a name and a cell for each column of trade_equal.h.
template <typename CellAt>
std::string equal_line(std::string_view name, CellAt cell_at) {
    std::string line = fmt::format("{:<20}", name);
    for (std::size_t i = 0; i < kEqualSeconds.size(); ++i)
        line += fmt::format("{:>11}", cell_at(i));
    return line + "\n";
}

std::string equal_time_rows(const Trade& trade, const ErrorMetric& metric) {
    std::string text = equal_line("", [](std::size_t i) { return format_seconds(kEqualSeconds[i]); });
    for (const EqualRow& row : equal_times(trade, metric, TradeTime::frame)) {
        text += equal_line(method_name(row.method), [&](std::size_t i) {
            return row.cells[i] ? format_error(metric, row.cells[i]->error, trade.noise) : "-";
        });
    }
    return text;
}

std::string equal_error_rows(const Trade& trade, const ErrorMetric& metric) {
    std::string text = equal_line("", [](std::size_t i) { return fmt::format("{:g}", kEqualErrors[i]); });
    for (const EqualRow& row : equal_errors(trade, metric, TradeTime::frame)) {
        text += equal_line(method_name(row.method), [&](std::size_t i) {
            return row.cells[i] ? format_seconds(row.cells[i]->seconds) : "-";
        });
    }
    return text;
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
