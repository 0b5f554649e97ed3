// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_json.h"

#include "compare/comparison/comparison_json.h"
#include "compare/trade/trade_cache.h"
#include "compare/trade/trade_front.h"

#include "base/file.h"

#include "small_trade.h"
#include "unit/image/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;

TEST(TradeJson, TopLevel) {
    const Json json = trade_to_json(test::small_trade());
    EXPECT_EQ(json["schema"], kTradeSchema);
    EXPECT_EQ(json["scene"], "rooms/hall.glb");
    EXPECT_EQ(json["reference"]["settings"]["samples"], 96);
    EXPECT_EQ(json["noise"]["mse"], 0.01);
    EXPECT_EQ(json["noise_reflective"]["mse"], 0.02);
    EXPECT_EQ(json["least_errors"]["mse"], 0.01);
    EXPECT_EQ(json["least_errors"]["flip"], 0.02);
    EXPECT_EQ(json["least_errors_reflective"]["flip"], 0.04);
    EXPECT_EQ(json["interrupted"], false);
    EXPECT_EQ(json["failed"], Json::array());
    EXPECT_FALSE(json.contains("methods"));
}

TEST(TradeJson, Runs) {
    const Trade trade = test::small_trade();
    const Json json = trade_to_json(trade);
    ASSERT_EQ(json["runs"].size(), 5u);
    const Json& run = json["runs"][3];
    EXPECT_EQ(run["name"], "direct/cube-map");
    EXPECT_EQ(run["options"], Json({"--reflection", "cube-map", "--map-size", "256"}));
    EXPECT_EQ(run["settings"]["samples"], 1);
    EXPECT_EQ(
        run["command"],
        "utsuri render rooms/hall.glb -o hall.exr --size 4x3 --reflection cube-map --map-size 256 --spp 1");
    EXPECT_EQ(run["prepare_seconds"], 4.0);
    EXPECT_EQ(run["frame_seconds"], 0.021);
    EXPECT_EQ(run["peak_bytes"], 3 << 20);
    EXPECT_EQ(run["metrics"], metrics_to_json(trade.runs[3].result.metrics));
    EXPECT_EQ(run["metrics_reflective"], metrics_to_json(trade.runs[3].result.metrics_reflective));
    EXPECT_EQ(run["errors"]["mse"], 0.81 - 0.01);
    EXPECT_EQ(run["errors"]["max"], 0.81);
    EXPECT_EQ(run["errors_reflective"]["mse"], 1.62 - 0.02);
}

TEST(TradeJson, Fronts) {
    const Json fronts = trade_to_json(test::small_trade())["fronts"];
    for (const char* pixels : {"all", "reflective"}) {
        for (const std::string& metric : error_metric_names()) {
            EXPECT_EQ(fronts["frame"][pixels][metric], Json({2, 3, 0, 1})) << metric;
            EXPECT_EQ(fronts["with_preparation"][pixels][metric], Json({0, 1})) << metric;
        }
    }
}

TEST(TradeJson, WhatWasNotMeasuredIsNull) {
    Trade trade = test::small_trade();
    trade.noise_reflective = Metrics();
    for (TradeRun& run : trade.runs)
        run.result.metrics_reflective = Metrics();
    const Json json = trade_to_json(trade);
    EXPECT_TRUE(json["runs"][0]["errors_reflective"]["mse"].is_null());
    EXPECT_TRUE(json["least_errors_reflective"]["flip"].is_null());
    EXPECT_EQ(json["fronts"]["frame"]["reflective"]["mse"], Json::array());
}

TEST(TradeJson, NamesSettingsThatFailed) {
    Trade trade = test::small_trade();
    trade.failures.push_back({{}, {"--reflection", "trace"}, "too large", ExitCode::usage});
    EXPECT_EQ(
        trade_to_json(trade)["failed"],
        Json::array(
            {{{"name", "direct/trace"}, {"options", {"--reflection", "trace"}}, {"message", "too large"}}}));
}

TEST(TradeJson, ReadsBackWhatAChoiceTakes) {
    Trade trade = test::small_trade();
    trade.runs[4].result.metrics.flip = Metrics::kNone;
    const Trade back = trade_from_json(Json::parse(trade_to_json(trade).dump()));
    ASSERT_EQ(back.runs.size(), trade.runs.size());
    for (std::size_t i = 0; i < trade.runs.size(); ++i) {
        EXPECT_EQ(back.render_command(back.runs[i]), trade.render_command(trade.runs[i]));
        EXPECT_EQ(back.runs[i].result.method, trade.runs[i].result.method);
    }
    for (const ErrorMetric& metric : error_metrics()) {
        for (const TradeTime time : {TradeTime::frame, TradeTime::with_preparation}) {
            for (const TradePixels pixels : {TradePixels::all, TradePixels::reflective}) {
                EXPECT_EQ(trade_points(back, metric, time, pixels),
                          trade_points(trade, metric, time, pixels));
            }
        }
    }
}

class KeptTrade : public test::ScratchFolder {};

TEST_F(KeptTrade, ComesBackUnderItsKeyOnly) {
    const Json key = {{"scene", "one"}, {"width", 4}};
    const std::filesystem::path file = trade_file(path("deep/folder"), key);
    EXPECT_FALSE(read_kept_trade(file, key));
    keep_trade(file, key, test::small_trade());
    const auto kept = read_kept_trade(file, key);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->runs.size(), test::small_trade().runs.size());
    EXPECT_FALSE(read_kept_trade(file, {{"scene", "one"}, {"width", 5}}));
    EXPECT_NE(trade_file("cache", {{"scene", "one"}, {"width", 5}}), trade_file("cache", key));
}

TEST_F(KeptTrade, DamagedFilesAreAsIfThereWereNone) {
    const Json key = {{"scene", "one"}};
    const std::filesystem::path file = path("trade.json");
    keep_trade(file, key, test::small_trade());
    const auto bytes = read_file(file, "read");
    const std::string whole(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const std::string& text :
         {std::string(), whole.substr(0, whole.size() / 2), std::string("[]"),
          std::string("{\"key\": {\"scene\": \"one\"}, \"trade\": {\"runs\": 1}}")}) {
        write_text_atomically(file, text);
        EXPECT_FALSE(read_kept_trade(file, key)) << text.size();
    }
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
    EXPECT_FALSE(read_kept_trade(file, key));
    EXPECT_THROW(keep_trade(file, key, test::small_trade()), InputError);
}

}  // namespace
}  // namespace utsuri
