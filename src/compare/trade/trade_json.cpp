// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_json.h"

#include "compare/comparison/comparison_json.h"
#include "compare/trade/trade_front.h"

#include "base/command_line.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// The errors of every metric beyond the reference's noise.
Json errors_to_json(const Metrics& measured, const Metrics& noise) {
    Json json;
    for (const ErrorMetric& metric : error_metrics()) {
        const double error = error_beyond_noise(metric, measured, noise);
        json[std::string(metric.name)] = std::isfinite(error) ? Json(error) : Json(nullptr);
    }
    return json;
}

Json least_errors_to_json(const Metrics& noise) {
    Json json;
    for (const ErrorMetric& metric : error_metrics()) {
        const double error = least_error(metric, noise);
        json[std::string(metric.name)] = std::isfinite(error) ? Json(error) : Json(nullptr);
    }
    return json;
}

Json run_to_json(const Trade& trade, const TradeRun& run) {
    Json json = result_to_json(run.result);
    json.erase("image");
    json["options"] = run.options;
    json["command"] = shell_command(trade.render_command(run));
    json["metrics"] = metrics_to_json(run.result.metrics);
    json["metrics_reflective"] = metrics_to_json(run.result.metrics_reflective);
    json["errors"] = errors_to_json(run.result.metrics, trade.noise);
    json["errors_reflective"] = errors_to_json(run.result.metrics_reflective, trade.noise_reflective);
    return json;
}

Json fronts_to_json(const Trade& trade, TradeTime time, TradePixels pixels) {
    Json json;
    for (const ErrorMetric& metric : error_metrics()) {
        Json runs = Json::array();
        for (const TradePoint& point : find_front(trade_points(trade, metric, time, pixels)))
            runs.push_back(point.run);
        json[std::string(metric.name)] = runs;
    }
    return json;
}

Json failures_to_json(const Trade& trade) {
    Json json = Json::array();
    for (const TradeFailure& failure : trade.failures) {
        json.push_back({{"name", method_name(failure.method)},
                        {"options", failure.options},
                        {"message", failure.message}});
    }
    return json;
}

/// null stands for what was not measured.
double number_from(const Json& json) {
    return json.is_null() ? Metrics::kNone : json.get<double>();
}

Metrics metrics_from(const Json& json) {
    Metrics metrics;
    for (const ErrorMetric& metric : error_metrics())
        metrics.*metric.value = number_from(json.at(std::string(metric.name)));
    return metrics;
}

TradeRun run_from(const Json& json) {
    TradeRun run;
    MethodResult& result = run.result;
    result.method =
        find_method(json.at("light").get<std::string>(), json.at("reflection").get<std::string>());
    result.samples = json.at("settings").at("samples").get<std::uint32_t>();
    result.prepare_seconds = json.at("prepare_seconds").get<double>();
    result.frame_seconds = json.at("frame_seconds").get<double>();
    result.metrics = metrics_from(json.at("metrics"));
    result.metrics_reflective = metrics_from(json.at("metrics_reflective"));
    run.options = json.at("options").get<std::vector<std::string>>();
    return run;
}

}  // namespace

Json trade_to_json(const Trade& trade) {
    Json json = comparison_to_json(trade.basis);
    json["schema"] = kTradeSchema;
    json["interrupted"] = trade.interrupted;
    json.erase("methods");
    json.erase("failed");
    json["reference"].erase("image");
    json["noise"] = metrics_to_json(trade.noise);
    json["noise_reflective"] = metrics_to_json(trade.noise_reflective);
    json["least_errors"] = least_errors_to_json(trade.noise);
    json["least_errors_reflective"] = least_errors_to_json(trade.noise_reflective);
    json["scene_options"] = trade.scene_options;
    json["runs"] = Json::array();
    for (const TradeRun& run : trade.runs)
        json["runs"].push_back(run_to_json(trade, run));
    json["fronts"] = {
        {"frame",
         {{"all", fronts_to_json(trade, TradeTime::frame, TradePixels::all)},
          {"reflective", fronts_to_json(trade, TradeTime::frame, TradePixels::reflective)}}},
        {"with_preparation",
         {{"all", fronts_to_json(trade, TradeTime::with_preparation, TradePixels::all)},
          {"reflective", fronts_to_json(trade, TradeTime::with_preparation, TradePixels::reflective)}}}};
    json["failed"] = failures_to_json(trade);
    return json;
}

Trade trade_from_json(const Json& json) {
    Trade trade;
    trade.noise = metrics_from(json.at("noise"));
    trade.noise_reflective = metrics_from(json.at("noise_reflective"));
    trade.scene_options = json.at("scene_options").get<std::vector<std::string>>();
    for (const Json& run : json.at("runs"))
        trade.runs.push_back(run_from(run));
    return trade;
}

}  // namespace utsuri
