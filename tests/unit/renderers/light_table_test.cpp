// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/light_table.h"

#include "base/check.h"

#include <gtest/gtest.h>

#include <numeric>

namespace utsuri {
namespace {

/// A threshold is a float32; over n entries the sum of their roundings stays below this many units roundoff.
double rounding(std::size_t entries) {
    return static_cast<double>(entries + 1) * 0x1p-24;
}

std::vector<double> chances(const std::vector<interop::LightInfo>& table) {
    std::vector<double> result(table.size(), 0.0);
    const double each = 1.0 / static_cast<double>(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto threshold = static_cast<double>(table[i].threshold);
        EXPECT_GE(threshold, 0.0);
        EXPECT_LE(threshold, 1.0);
        EXPECT_LT(table[i].alias, table.size());
        result[i] += each * threshold;
        result[table[i].alias] += each * (1.0 - threshold);
    }
    return result;
}

void expect_proportional(const std::vector<double>& weights) {
    std::vector<interop::LightInfo> lights(weights.size());
    make_light_table(weights, lights);
    const std::vector<double> found = chances(lights);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    double probabilities = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double expected = weights[i] / sum;
        EXPECT_NEAR(found[i], expected, rounding(weights.size()) / static_cast<double>(weights.size())) << i;
        EXPECT_NEAR(static_cast<double>(lights[i].probability), expected, expected * 0x1p-24) << i;
        probabilities += static_cast<double>(lights[i].probability);
    }
    EXPECT_NEAR(probabilities, 1.0, 1e-6);
}

TEST(LightTable, PicksInProportionToTheWeights) {
    expect_proportional({1.0});
    expect_proportional({1.0, 1.0, 1.0, 1.0});
    expect_proportional({0.1, 0.2, 0.3, 0.4});
    expect_proportional({5.0, 0.0, 1.0});
    expect_proportional({1e-30, 1e-30, 3e-30});
    expect_proportional({1e30, 2e30});
}

TEST(LightTable, FindsTheBrightOneAmongMany) {
    std::vector<double> weights(100000, 1.0);
    weights[77777] = 1e5;
    expect_proportional(weights);
}

TEST(LightTable, NeverPicksALightWithoutWeight) {
    std::vector<interop::LightInfo> lights(4);
    make_light_table(std::vector<double>{0.0, 2.0, 0.0, 1.0}, lights);
    const std::vector<double> found = chances(lights);
    EXPECT_EQ(found[0], 0.0);
    EXPECT_EQ(found[2], 0.0);
}

TEST(LightTable, TakesNoLightsAtAll) {
    EXPECT_NO_THROW(make_light_table({}, {}));
}

TEST(LightTable, RefusesWeightsThatAreAllZero) {
    std::vector<interop::LightInfo> lights(2);
    EXPECT_THROW(make_light_table(std::vector<double>{0.0, 0.0}, lights), CheckFailure);
}

}  // namespace
}  // namespace utsuri
