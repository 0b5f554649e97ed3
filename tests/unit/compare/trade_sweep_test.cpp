// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <string>

namespace utsuri {
namespace {

using testing::ElementsAre;

std::vector<TradeSetting> settings_of(std::string_view reflection, const MapSettings& given) {
    return swept_settings({find_method("direct", reflection)}, given);
}

TEST(Sweep, SamplesAreThePowersOfTwoAndTheMost) {
    EXPECT_THAT(swept_samples(1), ElementsAre(1));
    EXPECT_THAT(swept_samples(16), ElementsAre(1, 2, 4, 8, 16));
    EXPECT_THAT(swept_samples(20), ElementsAre(1, 2, 4, 8, 16, 20));
    EXPECT_EQ(swept_samples(1u << 24).size(), 25u);
}

TEST(Sweep, TracingHasNothingToSet) {
    const auto settings = settings_of("trace", {});
    ASSERT_EQ(settings.size(), 1u);
    EXPECT_THAT(settings[0].options, ElementsAre("--reflection", "trace"));
}

TEST(Sweep, MapsAreTriedUpToTheSizeAskedForAndFitted) {
    MapSettings given;
    given.size = 100;
    given.samples = 3;
    const auto settings = settings_of("cube-map", given);
    ASSERT_EQ(settings.size(), 4u);
    EXPECT_THAT(settings[0].options, ElementsAre("--reflection", "cube-map", "--map-size", "25"));
    EXPECT_EQ(settings[0].maps.size, 25u);
    EXPECT_EQ(settings[1].maps.size, 100u);
    EXPECT_EQ(settings[1].maps.samples, 3u);
    EXPECT_THAT(settings[2].options, ElementsAre("--reflection", "cube-map", "--map-size", "fit"));
    EXPECT_TRUE(settings[2].maps.fitted);
}

TEST(Sweep, NoSizeIsTriedTwiceAndNoneIsNothing) {
    MapSettings given;
    given.size = 1;
    const auto smallest = settings_of("cube-map", given);
    ASSERT_EQ(smallest.size(), 3u) << "fitted, with one probe and with several";
    EXPECT_EQ(smallest[0].maps.size, 1u);
    given.size = 2;
    EXPECT_EQ(settings_of("cube-map", given).size(), 4u);
}

TEST(Sweep, FittedMapsAskedForHaveNoOtherSizes) {
    MapSettings given;
    given.fitted = true;
    for (const char* reflection : {"polygon-map", "hybrid"}) {
        for (const TradeSetting& setting : settings_of(reflection, given)) {
            EXPECT_TRUE(setting.maps.fitted);
            EXPECT_THAT(setting.options, testing::Contains("fit"));
        }
    }
}

TEST(Sweep, PolygonsAreTriedUnlessTheirSizeIsGiven) {
    MapSettings given;
    const auto settings = settings_of("polygon-map", given);
    EXPECT_THAT(settings.back().options,
                ElementsAre("--reflection", "polygon-map", "--map-size", "256", "--polygon-error", "1"));
    EXPECT_DOUBLE_EQ(settings.back().maps.refinement.error.value(), std::numbers::pi / 180.0);
    given.refinement.edge = 0.1;
    for (const TradeSetting& setting : settings_of("polygon-map", given)) {
        EXPECT_EQ(setting.maps.refinement.edge, 0.1);
        EXPECT_FALSE(setting.maps.refinement.error);
    }
}

TEST(Sweep, SeveralProbesAreTriedUnlessTheirNumberIsGiven) {
    MapSettings given;
    const auto settings = settings_of("cube-map", given);
    EXPECT_THAT(settings.back().options,
                ElementsAre("--reflection", "cube-map", "--map-size", "256", "--probes", "4"));
    EXPECT_EQ(settings.back().maps.most_probes, 4u);
    EXPECT_EQ(settings_of("sphere-map", given).back().maps.most_probes, 1u);
    given.most_probes = 2;
    for (const TradeSetting& setting : settings_of("cube-map", given))
        EXPECT_EQ(setting.maps.most_probes, 2u);
}

std::vector<double> tolerances_tried(const Tolerance& given) {
    MapSettings maps;
    maps.fitted = true;
    maps.most_probes = 2;
    maps.tolerance = given;
    std::vector<double> tried;
    for (const TradeSetting& setting : settings_of("hybrid", maps)) {
        EXPECT_EQ(setting.maps.tolerance.of, given.of);
        tried.push_back(setting.maps.tolerance.most);
    }
    return tried;
}

TEST(Sweep, HybridIsTriedAtTolerancesAroundTheOneAskedFor) {
    EXPECT_THAT(tolerances_tried({}), ElementsAre(1.0, 0.5, 2.0, 4.0));
    EXPECT_THAT(tolerances_tried({Tolerance::Of::place, 0.0}), ElementsAre(0.0));
    EXPECT_THAT(tolerances_tried({Tolerance::Of::radiance, 0.3}), ElementsAre(0.3, 0.15, 0.6, 1.0));
    EXPECT_THAT(tolerances_tried({Tolerance::Of::radiance, 1.0}), ElementsAre(1.0, 0.5));
    EXPECT_THAT(settings_of("hybrid", {}).back().options,
                ElementsAre("--reflection", "hybrid", "--map-size", "256", "--tolerance", "4"));
    MapSettings given;
    given.tolerance = {Tolerance::Of::radiance, 0.07};
    EXPECT_THAT(settings_of("hybrid", given)[0].options,
                ElementsAre("--reflection", "hybrid", "--map-size", "64", "--tolerance", "7%"));
}

TEST(Sweep, EveryMethodIsTriedAndNoSettingTwice) {
    const auto settings = swept_settings(all_methods(light_methods().front()), {});
    std::set<std::vector<std::string>> options;
    std::set<std::string> methods;
    for (const TradeSetting& setting : settings) {
        options.insert(setting.options);
        methods.insert(method_name(setting.method));
        EXPECT_EQ(setting.options[0], "--reflection");
        EXPECT_EQ(setting.options[1], setting.method.reflection->name);
        // A size on the command line is made or refused: what is measured is what the command renders.
        const bool names_size = std::ranges::count(setting.options, "--map-size") > 0;
        EXPECT_EQ(setting.maps.shares_room, !names_size);
    }
    EXPECT_EQ(options.size(), settings.size());
    EXPECT_EQ(methods.size(), all_methods(light_methods().front()).size());
}

}  // namespace
}  // namespace utsuri
