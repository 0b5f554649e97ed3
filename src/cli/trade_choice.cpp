// SPDX-License-Identifier: Apache-2.0
#include "cli/trade_choice.h"

#include "compare/comparison/comparison_table.h"
#include "compare/trade/run_trade.h"
#include "compare/trade/trade_cache.h"
#include "compare/trade/trade_table.h"

#include "base/command_line.h"
#include "base/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace utsuri {
namespace {

/// Picture options whose values the runs of a sweep set themselves.
constexpr std::array<std::string_view, 2> kSweptOptions = {"map-size", "tolerance"};

/// As the XDG base directory specification has it; none without a home.
std::optional<std::filesystem::path> cache_folder() {
    const auto absolute = [](const char* name) -> std::optional<std::filesystem::path> {
        const char* value = std::getenv(name);
        if (value == nullptr || !std::filesystem::path(value).is_absolute()) return std::nullopt;
        return std::filesystem::path(value);
    };
    if (const auto cache = absolute("XDG_CACHE_HOME")) return *cache / "utsuri";
    if (const auto home = absolute("HOME")) return *home / ".cache" / "utsuri";
    return std::nullopt;
}

[[noreturn]] void refuse_time(const std::vector<TradePoint>& points, const ChoiceOptions& options) {
    double least = std::numeric_limits<double>::infinity();
    for (const TradePoint& point : points)
        least = std::min(least, point.seconds);
    throw UsageError("choose a run", fmt::format("within {}", options.within),
                     fmt::format("the fastest takes {}; allow at least that", format_seconds(least)));
}

[[noreturn]] void refuse_error(const Trade& trade, const ErrorMetric& metric,
                               const std::vector<TradePoint>& points, double error) {
    const double hidden = least_error(metric, trade.noise);
    const std::string object = fmt::format("with {} at most {:g}", metric.title, error);
    if (error < hidden) {
        throw UsageError("choose a run", object,
                         fmt::format("the noise of the reference hides errors below {:.3g}; allow at least "
                                     "that, or give the reference of 'utsuri trade' more samples",
                                     hidden));
    }
    double least = std::numeric_limits<double>::infinity();
    for (const TradePoint& point : points)
        least = std::min(least, point.error);
    throw UsageError("choose a run", object,
                     fmt::format("the least found is {:.3g}; allow at least that", least));
}

}  // namespace

void add_choice_options(CLI::App& command, ChoiceOptions& options) {
    CLI::Option* within =
        command.add_option("--within", options.within,
                           "Choose the least wrong method and settings whose frame takes at most so long, "
                           "such as 33ms");
    command
        .add_option("--error", options.error,
                    "Choose the fastest method and settings that are wrong by at most so much, such as 0.01")
        ->check(finite_range(0.0, std::numeric_limits<double>::max()))
        ->excludes(within);
    command.add_option("--metric", options.metric, "Error that counts")
        ->check(CLI::IsMember(error_metric_names()))
        ->capture_default_str();
}

ComparisonSettings trade_settings(const PictureOptions& picture, const std::vector<Method>& methods,
                                  const LightMethod& light) {
    ComparisonSettings settings;
    settings.render = picture.render_settings();
    settings.maps = picture.map_settings();
    settings.light = &light;
    settings.methods = methods;
    settings.samples = kTradeSamples;
    settings.exposure = picture.exposure;
    return settings;
}

std::vector<std::string> given_picture_options(const CLI::App& command) {
    CLI::App pictures;
    PictureOptions unused;
    add_picture_options(pictures, unused);
    std::vector<std::string> words;
    for (const CLI::Option* option : pictures.get_options()) {
        const std::string& name = option->get_lnames().front();
        const CLI::Option* given = command.get_option_no_throw("--" + name);
        const bool is_swept =
            std::find(kSweptOptions.begin(), kSweptOptions.end(), name) != kSweptOptions.end();
        if (is_swept || given == nullptr || given->count() == 0) continue;
        words.push_back("--" + name);
        words.push_back(given->results().back());
    }
    return words;
}

TradePoint choose_run(const Trade& trade, const ChoiceOptions& options) {
    const ErrorMetric& metric = parse_error_metric(options.metric);
    const std::vector<TradePoint> points = trade_points(trade, metric, TradeTime::frame);
    if (points.empty()) throw UsageError("choose a run", "", "none was finished");
    if (!options.within.empty()) {
        const auto best = best_within(points, parse_duration(options.within));
        return best ? *best : (refuse_time(points, options), TradePoint());
    }
    // What noise hides is not known to be as small as it looks.
    const bool can_be_told = *options.error >= least_error(metric, trade.noise);
    const auto fastest = can_be_told ? fastest_for(points, *options.error) : std::nullopt;
    return fastest ? *fastest : (refuse_error(trade, metric, points, *options.error), TradePoint());
}

std::string choice_text(const Trade& trade, const TradePoint& point, const ChoiceOptions& options) {
    const ErrorMetric& metric = parse_error_metric(options.metric);
    const TradeRun& run = trade.runs[point.run];
    return fmt::format("chosen: {} {}, expected {} {}, frame {}, preparation {}\n",
                       method_name(run.result.method), settings_text(run), metric.title,
                       format_error(metric, point.error, trade.noise), format_seconds(point.seconds),
                       format_seconds(run.result.prepare_seconds));
}

nlohmann::ordered_json choice_to_json(const Trade& trade, const TradePoint& point,
                                      const ChoiceOptions& options) {
    const TradeRun& run = trade.runs[point.run];
    return {{"name", method_name(run.result.method)},
            {"options", run.options},
            {"samples", run.result.samples},
            {"metric", options.metric},
            {"error", point.error},
            {"frame_seconds", point.seconds},
            {"prepare_seconds", run.result.prepare_seconds}};
}

void keep_for_later(const Session& session, const Camera& camera, const ComparisonSettings& settings,
                    const std::vector<std::string>& options, const Trade& trade) {
    const auto folder = cache_folder();
    if (!folder) return;
    const nlohmann::ordered_json key = trade_key(session, camera, settings, options);
    try {
        keep_trade(trade_file(*folder, key), key, trade);
    } catch (const Error& error) {
        fmt::print(stderr, "note: the trade is not kept for later: {}\n", error.what());
    }
}

Trade kept_or_measured(Session& session, const Camera& camera, const ComparisonSettings& settings,
                       const std::vector<std::string>& options, const CommonOptions& common,
                       Progress& progress) {
    if (const auto folder = cache_folder()) {
        const nlohmann::ordered_json key = trade_key(session, camera, settings, options);
        if (auto kept = read_kept_trade(trade_file(*folder, key), key)) return std::move(*kept);
    }
    if (!common.quiet) {
        fmt::print(stderr,
                   "note: no trade is kept for this scene, camera, size and device: measuring it, "
                   "which takes minutes\n");
    }
    Trade trade = run_trade(session, camera, settings, progress);
    if (trade.interrupted) throw Interrupted();
    keep_for_later(session, camera, settings, options, trade);
    return trade;
}

}  // namespace utsuri
