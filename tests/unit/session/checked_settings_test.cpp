// SPDX-License-Identifier: Apache-2.0
#include "session/checked_settings.h"

#include "base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace utsuri {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// What is wrong with the settings of a picture after something was done to those that are there by default.
template <typename Spoil>
std::string error_after(const Spoil& spoil) {
    PictureSettings settings;
    spoil(settings);
    try {
        EXPECT_EQ(&checked(settings), &settings);
    } catch (const UsageError& error) {
        return error.what();
    }
    return {};
}

TEST(CheckedSettings, PassWhereNothingWasChanged) {
    EXPECT_THAT(error_after([](PictureSettings&) {}), IsEmpty());
}

TEST(CheckedSettings, NeedBothAxesOfAMethod) {
    EXPECT_THAT(error_after([](PictureSettings& s) { s.method.light = nullptr; }),
                HasSubstr("take it from find_method()"));
    EXPECT_THAT(error_after([](PictureSettings& s) { s.method.reflection = nullptr; }),
                HasSubstr("take it from find_method()"));
}

TEST(CheckedSettings, NeedAPictureThatHasPixels) {
    EXPECT_EQ(error_after([](PictureSettings& s) { s.render.width = 0; }),
              "make a picture of 0 x 384 pixels: each edge must have 1 to 16384");
    EXPECT_THAT(error_after([](PictureSettings& s) { s.render.height = 0; }), HasSubstr("512 x 0"));
    const auto with_edge = [](std::uint32_t edge) {
        return error_after([&](PictureSettings& s) { s.render.width = s.render.height = edge; });
    };
    EXPECT_THAT(with_edge(1), IsEmpty());
    EXPECT_THAT(with_edge(kLargestPictureEdge), IsEmpty());
    EXPECT_THAT(with_edge(kLargestPictureEdge + 1), HasSubstr("each edge must have"));
}

TEST(CheckedSettings, NeedACamera) {
    EXPECT_EQ(error_after([](PictureSettings& s) { s.camera.vertical_fov = 0.0; }),
              "use camera vertical_fov: is 0; must be above 0 and below pi, in "
              "radians");
    EXPECT_THAT(error_after([](PictureSettings& s) { s.camera.up *= 2.0; }), HasSubstr("use camera up"));
}

TEST(CheckedSettings, NeedMapsInTheirRanges) {
    EXPECT_EQ(error_after([](PictureSettings& s) { s.maps.samples = 0; }),
              "use map settings samples: is 0; must be from 1 to 65536");
}

TEST(CheckedSettings, BoundKeptLight) {
    const auto error_with = [](const LightSettings& light) {
        try {
            EXPECT_EQ(&checked(light), &light);
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(error_with({}), IsEmpty());
    for (const LightSettings& bad : {LightSettings{0.0}, LightSettings{kNan}, LightSettings{0.1, 0},
                                     LightSettings{0.1, kMostLightSamples + 1}, LightSettings{0.1, 1, 0, 0}})
        EXPECT_THAT(error_with(bad), HasSubstr("keep light on surfaces"));
}

}  // namespace
}  // namespace utsuri
