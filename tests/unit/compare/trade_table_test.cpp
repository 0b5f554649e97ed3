// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_table.h"

#include "small_trade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace utsuri {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t kColumns = 110;

const ErrorMetric& rel_mse() {
    return parse_error_metric("rel_mse");
}

/// The words of every line after the one that is `title`, up to an empty line.
std::vector<std::vector<std::string>> section(const std::string& text, const std::string& title) {
    std::istringstream stream(text);
    std::vector<std::vector<std::string>> rows;
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (inside && line.empty()) return rows;
        if (inside) {
            std::istringstream words(line);
            rows.emplace_back(std::istream_iterator<std::string>(words),
                              std::istream_iterator<std::string>());
        }
        inside = inside || line == title;
    }
    EXPECT_TRUE(inside) << "no " << title << " in\n" << text;
    return rows;
}

TEST(TradeTable, Fronts) {
    const std::string text = trade_table(test::small_trade(), rel_mse());
    const auto frame = section(text, "nothing beats these, by the time of a frame");
    ASSERT_EQ(frame.size(), 5u);
    EXPECT_THAT(frame[0], ElementsAre("frame", "prepare", "relMSE", "memory", "method", "settings"));
    EXPECT_THAT(frame[1], ElementsAre("20.0", "ms", "1.00", "s", "0.9", "3.00", "MiB", "direct/cube-map",
                                      "--map-size", "64", "--spp", "1"));
    EXPECT_THAT(frame[4],
                ElementsAre("400", "ms", "0", "us", "0.2", "3.00", "MiB", "direct/trace", "--spp", "2"));
    EXPECT_EQ(section(text, "nothing beats these, by the time of preparation and a frame").size(), 3u);
}

TEST(TradeTable, EqualTimes) {
    const auto rows =
        section(trade_table(test::small_trade(), rel_mse()), "relMSE at equal times of a frame");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_THAT(rows[0], ElementsAre("10.0", "ms", "33.0", "ms", "100", "ms", "330", "ms", "1.00", "s",
                                     "3.30", "s", "10.0", "s"));
    EXPECT_THAT(rows[1], ElementsAre("direct/trace", "-", "-", "-", "0.4", "0.2", "0.2", "0.2"));
    EXPECT_THAT(rows[2], ElementsAre("direct/cube-map", "-", "0.8", "0.8", "0.8", "0.8", "0.8", "0.8"));
}

TEST(TradeTable, EqualErrors) {
    const auto rows = section(trade_table(test::small_trade(), rel_mse()), "time of a frame at equal relMSE");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_THAT(rows[0], ElementsAre("1", "0.3", "0.1", "0.03", "0.01", "0.003", "0.001"));
    EXPECT_THAT(rows[1], ElementsAre("direct/trace", "200", "ms", "400", "ms", "-", "-", "-", "-", "-"));
    EXPECT_THAT(rows[2], ElementsAre("direct/cube-map", "20.0", "ms", "-", "-", "-", "-", "-", "-"));
}

TEST(TradeTable, SaysWhatNoiseHides) {
    Trade trade = test::small_trade();
    EXPECT_THAT(trade_table(trade, rel_mse()), HasSubstr("None below 0.01 is told from the noise"));
    EXPECT_THAT(trade_table(trade, rel_mse()), HasSubstr("whose noise is subtracted"));
    EXPECT_THAT(trade_table(trade, parse_error_metric("flip")), Not(HasSubstr("subtracted")));
    EXPECT_THAT(trade_table(trade, rel_mse()), Not(HasSubstr("<0.01")));
    trade.runs[1].result.metrics = test::equal_metrics(0.012);
    EXPECT_THAT(trade_table(trade, rel_mse()), HasSubstr("<0.01"));
}

TEST(TradeTable, NoiselessReferencesHideNothing) {
    EXPECT_EQ(format_error(rel_mse(), 0.0, test::equal_metrics(0.0)), "0");
    EXPECT_EQ(format_error(rel_mse(), 0.5, test::equal_metrics(0.0)), "0.5");
}

TEST(TradeTable, FitsATerminal) {
    Trade trade = test::small_trade();
    for (TradeRun& run : trade.runs) {
        run.result.frame_seconds *= 1.2345;
        run.result.prepare_seconds = 1234.5;
        run.result.metrics = test::equal_metrics(run.result.metrics.mse * 1.23456789e-5);
        if (run.options.size() > 2) run.options.insert(run.options.end(), {"--polygon-error", "0.25"});
    }
    std::istringstream stream(trade_table(trade, rel_mse()));
    for (std::string line; std::getline(stream, line);)
        EXPECT_LE(line.size(), kColumns) << line;
}

TEST(TradeTable, SaysWhyASettingIsMissing) {
    Trade trade = test::small_trade();
    trade.failures.push_back(
        {{}, {"--reflection", "cube-map", "--map-size", "4096"}, "too large", ExitCode::usage});
    EXPECT_THAT(trade_table(trade, rel_mse()),
                HasSubstr("--reflection cube-map --map-size 4096 is missing: too large"));
}

TEST(TradeTable, NothingWasFinished) {
    Trade trade = test::small_trade();
    trade.runs.clear();
    EXPECT_THAT(trade_table(trade, rel_mse()), HasSubstr("0 runs"));
}

}  // namespace
}  // namespace utsuri
