// SPDX-License-Identifier: Apache-2.0
#include "compare/trade_page.h"

#include "compare/error_metric.h"
#include "compare/html_page.h"
#include "compare/page_files.h"
#include "compare/trade_json.h"

#include "base/file.h"

#include <nlohmann/json.hpp>

#include <array>

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

}  // namespace

std::string make_trade_page(const Trade& trade, std::string_view metric) {
    Json json = trade_to_json(trade);
    json["metric"] = metric;
    json["titles"] = metrics_to_titles();
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
    const std::string json = trade_to_json(trade).dump(2, ' ', false, Json::error_handler_t::replace);
    write_text_atomically(folder / "trade.json", json + "\n");
    write_text_atomically(folder / "trade.html", make_trade_page(trade, metric));
}

}  // namespace utsuri
