// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_page.h"

#include "compare/page/html_page.h"
#include "compare/page/json_text.h"
#include "compare/page/page_files.h"
#include "compare/trade/error_metric.h"
#include "compare/trade/trade_equal.h"
#include "compare/trade/trade_json.h"

#include "base/file.h"

#include <nlohmann/json.hpp>

#include <array>
#include <vector>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kJpeg = "image/jpeg";

/// Titles of the metrics, so that the page need not know them.
Json metrics_to_titles() {
    Json titles;
    for (const ErrorMetric& metric : error_metrics())
        titles[std::string(metric.name)] = metric.title;
    return titles;
}

/// For each method its name and the indices of its runs, null for none.
Json rows_to_json(const std::vector<EqualRow>& rows) {
    Json json = Json::array();
    for (const EqualRow& row : rows) {
        Json runs = Json::array();
        for (const std::optional<TradePoint>& cell : row.cells)
            runs.push_back(cell ? Json(cell->run) : Json(nullptr));
        json.push_back({{"name", method_name(row.method)}, {"runs", std::move(runs)}});
    }
    return json;
}

Json equal_rows_to_json(const Trade& trade, TradeTime time, TradePixels pixels) {
    Json json;
    for (const ErrorMetric& metric : error_metrics()) {
        json[std::string(metric.name)] = {
            {"times", rows_to_json(equal_times(trade, metric, time, pixels))},
            {"errors", rows_to_json(equal_errors(trade, metric, time, pixels))}};
    }
    return json;
}

/// The tables of trade_equal.h, found as the fronts of trade_to_json() are.
Json equal_to_json(const Trade& trade) {
    const auto of_time = [&](TradeTime time) -> Json {
        return {{"all", equal_rows_to_json(trade, time, TradePixels::all)},
                {"reflective", equal_rows_to_json(trade, time, TradePixels::reflective)}};
    };
    return {{"seconds", kEqualSeconds},
            {"errors", kEqualErrors},
            {"frame", of_time(TradeTime::frame)},
            {"with_preparation", of_time(TradeTime::with_preparation)}};
}

}  // namespace

std::string make_trade_page(const Trade& trade, std::string_view metric) {
    Json json = trade_to_json(trade);
    json["metric"] = metric;
    json["titles"] = metrics_to_titles();
    json["equal"] = equal_to_json(trade);
    json["pictures"] = Json::array();
    for (const TradeRun& run : trade.runs)
        json["pictures"].push_back(data_uri(kJpeg, run.picture));
    const std::string data = script_safe(json);
    const std::string title = html_text(valid_utf8(trade.basis.scene));
    const std::array<Part, 7> parts = {{{"{{title}}", title},
                                        {"/*{{page style}}*/", file_text(page_files::kPageStyle)},
                                        {"/*{{style}}*/", file_text(page_files::kTradeStyle)},
                                        {"{{data}}", data},
                                        {"/*{{page script}}*/", file_text(page_files::kPageScript)},
                                        {"/*{{chart}}*/", file_text(page_files::kTradeChart)},
                                        {"/*{{script}}*/", file_text(page_files::kTradeScript)}}};
    return fill_template(file_text(page_files::kTradeTemplate), parts);
}

void write_trade(const Trade& trade, std::string_view metric, const std::filesystem::path& folder) {
    write_text_atomically(folder / "trade.json", json_text(trade_to_json(trade), 2) + "\n");
    write_text_atomically(folder / "trade.html", make_trade_page(trade, metric));
}

}  // namespace utsuri
