// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_front.h"

#include "small_trade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace utsuri {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::size_t> runs(const std::vector<TradePoint>& points) {
    std::vector<std::size_t> indices;
    for (const TradePoint& point : points)
        indices.push_back(point.run);
    return indices;
}

/// Whether `a` makes `b` pointless.
bool beats(const TradePoint& a, const TradePoint& b) {
    return a.seconds <= b.seconds && a.error <= b.error && (a.seconds < b.seconds || a.error < b.error);
}

TEST(Front, KeepsWhatNothingBeats) {
    EXPECT_THAT(runs(find_front({{3, 1, 0}, {1, 3, 1}, {2, 2, 2}, {2.5, 2.5, 3}, {4, 1, 4}})),
                ElementsAre(1, 2, 0));
    EXPECT_THAT(find_front({}), IsEmpty());
}

TEST(Front, OfEqualPointsTheFirst) {
    EXPECT_THAT(runs(find_front({{2, 2, 0}, {1, 3, 1}, {2, 2, 2}})), ElementsAre(1, 0));
    EXPECT_THAT(runs(find_front({{1, 2, 0}, {1, 1, 1}, {2, 1, 2}})), ElementsAre(1));
}

// Against the definition, on coarse random points, where ties are frequent.
TEST(Front, IsWhatItsDefinitionSays) {
    std::mt19937 generator(1);
    std::uniform_int_distribution<int> coordinate(0, 12);
    for (int round = 0; round < 200; ++round) {
        std::vector<TradePoint> points;
        for (std::size_t i = 0; i < 30; ++i) {
            points.push_back(
                {static_cast<double>(coordinate(generator)), static_cast<double>(coordinate(generator)), i});
        }
        const std::vector<TradePoint> front = find_front(points);
        for (const TradePoint& point : points) {
            bool beaten = false;
            bool repeated = false;
            for (const TradePoint& other : points) {
                beaten |= beats(other, point);
                repeated |=
                    other.run < point.run && other.seconds == point.seconds && other.error == point.error;
            }
            const bool found = std::find(front.begin(), front.end(), point) != front.end();
            EXPECT_EQ(found, !beaten && !repeated) << point.seconds << ", " << point.error;
        }
        EXPECT_TRUE(std::is_sorted(front.begin(), front.end(),
                                   [](const auto& a, const auto& b) { return a.seconds < b.seconds; }));
    }
}

TEST(Choice, LeastWrongWithinATime) {
    const std::vector<TradePoint> points = {{1, 5, 0}, {2, 3, 1}, {3, 3, 2}, {4, 1, 3}};
    EXPECT_EQ(best_within(points, 3.5)->run, 1u);  // of two equally wrong ones the faster
    EXPECT_EQ(best_within(points, 4.0)->run, 3u);
    EXPECT_EQ(best_within(points, 1.0)->run, 0u);
    EXPECT_FALSE(best_within(points, 0.5));
}

TEST(Choice, FastestForAnError) {
    const std::vector<TradePoint> points = {{1, 5, 0}, {2, 3, 1}, {2, 2, 2}, {4, 1, 3}};
    EXPECT_EQ(fastest_for(points, 3.0)->run, 2u);  // of two equally fast ones the less wrong
    EXPECT_EQ(fastest_for(points, 1.0)->run, 3u);
    EXPECT_EQ(fastest_for(points, 9.0)->run, 0u);
    EXPECT_FALSE(fastest_for(points, 0.5));
}

TEST(TradePoints, AreTimesAndErrorsBeyondNoise) {
    const Trade trade = test::small_trade();
    const ErrorMetric& rel_mse = parse_error_metric("rel_mse");
    const auto frame = trade_points(trade, rel_mse, TradeTime::frame);
    ASSERT_EQ(frame.size(), 5u);
    EXPECT_DOUBLE_EQ(frame[2].seconds, 0.02);
    EXPECT_DOUBLE_EQ(frame[2].error, 0.9);
    const auto total = trade_points(trade, rel_mse, TradeTime::with_preparation, TradePixels::reflective);
    EXPECT_DOUBLE_EQ(total[2].seconds, 1.02);
    EXPECT_DOUBLE_EQ(total[2].error, 2.0 * 0.91 - 0.02);
    EXPECT_DOUBLE_EQ(trade_points(trade, parse_error_metric("flip"), TradeTime::frame)[2].error, 0.91);
}

TEST(TradePoints, FrontsDifferWithAndWithoutPreparation) {
    const Trade trade = test::small_trade();
    const ErrorMetric& metric = parse_error_metric("rel_mse");
    EXPECT_THAT(runs(find_front(trade_points(trade, metric, TradeTime::frame))), ElementsAre(2, 3, 0, 1));
    EXPECT_THAT(runs(find_front(trade_points(trade, metric, TradeTime::with_preparation))),
                ElementsAre(0, 1));
}

TEST(TradePoints, OfRunsThatNoiseHidesTheFastestIsOnTheFront) {
    Trade trade = test::small_trade();
    for (const std::size_t run : {0, 1})
        trade.runs[run].result.metrics = test::equal_metrics(run == 0 ? 0.015 : 0.011);
    const auto front = find_front(trade_points(trade, parse_error_metric("mse"), TradeTime::frame));
    EXPECT_EQ(front.back().run, 0u);
    EXPECT_EQ(front.back().error, 0.01);
}

TEST(TradePoints, RunsWithoutAnErrorAreLeftOut) {
    Trade trade = test::small_trade();
    for (TradeRun& run : trade.runs)
        run.result.metrics_reflective = Metrics();
    const ErrorMetric& metric = parse_error_metric("rel_mse");
    EXPECT_THAT(trade_points(trade, metric, TradeTime::frame, TradePixels::reflective), IsEmpty());
    EXPECT_EQ(trade_points(trade, metric, TradeTime::frame).size(), trade.runs.size());
}

}  // namespace
}  // namespace utsuri
