// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_page.h"

#include "compare/trade/trade_equal.h"
#include "compare/trade/trade_json.h"

#include "small_trade.h"
#include "unit/image/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

Json data_of(const std::string& page) {
    constexpr std::string_view kBegin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(kBegin) + kBegin.size();
    return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(TradePage, HoldsTheTradeAndItsPictures) {
    const Trade trade = test::small_trade();
    Json data = data_of(make_trade_page(trade, "flip"));
    EXPECT_EQ(data["metric"], "flip");
    EXPECT_EQ(data["titles"]["rel_mse"], "relMSE");
    ASSERT_EQ(data["pictures"].size(), trade.runs.size());
    EXPECT_EQ(data["pictures"][0], "data:image/jpeg;base64,/9j/");
    for (const char* name : {"metric", "titles", "pictures", "equal"})
        data.erase(name);
    EXPECT_EQ(data, Json::parse(trade_to_json(trade).dump()));
}

TEST(TradePage, HoldsTheTablesOfEqualTimesAndErrors) {
    const Trade trade = test::small_trade();
    const Json equal = data_of(make_trade_page(trade, "rel_mse"))["equal"];
    EXPECT_EQ(equal["seconds"], Json(kEqualSeconds));
    EXPECT_EQ(equal["errors"], Json(kEqualErrors));
    const ErrorMetric& flip = parse_error_metric("flip");
    const auto rows = equal_errors(trade, flip, TradeTime::with_preparation, TradePixels::reflective);
    const Json& written = equal["with_preparation"]["reflective"]["flip"]["errors"];
    ASSERT_EQ(written.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(written[i]["name"], method_name(rows[i].method));
        for (std::size_t c = 0; c < kEqualErrors.size(); ++c) {
            const auto& cell = rows[i].cells[c];
            EXPECT_EQ(written[i]["runs"][c], cell ? Json(cell->run) : Json(nullptr));
        }
    }
}

TEST(TradePage, FetchesNothing) {
    const std::string page = make_trade_page(test::small_trade(), "rel_mse");
    EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:;"));
    for (const char* words : {"src=\"http", "href=\"http", "url(", "@import", "{{", "/*{{"})
        EXPECT_THAT(page, Not(HasSubstr(words)));
}

TEST(TradePage, TextOfTheSceneIsNoMarkup) {
    Trade trade = test::small_trade();
    trade.basis.scene = "</script><script>alert(1)</script>\xff";
    const std::string page = make_trade_page(trade, "rel_mse");
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;"));
    EXPECT_EQ(data_of(page)["scene"], "</script><script>alert(1)</script>\xef\xbf\xbd");
}

class WriteTrade : public test::ScratchFolder {};

TEST_F(WriteTrade, LeavesTheTwoFiles) {
    write_trade(test::small_trade(), "rel_mse", path(""));
    EXPECT_EQ(listing(), (std::set<std::string>{"trade.json", "trade.html"}));
    EXPECT_THROW(write_trade(test::small_trade(), "rel_mse", path("missing")), InputError);
}

}  // namespace
}  // namespace utsuri
