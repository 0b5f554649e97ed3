// SPDX-License-Identifier: Apache-2.0
#include "image/tone.h"

#include "image/colour.h"

#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace utsuri {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// The luminance of grey is its value times a sum of rounded weights; a logarithm turns 1.2e-7 into this many
/// stops.
constexpr double kStops = 4e-7;

TEST(AutoExposure, ConstantPictureIsShownAtTheLevel) {
    EXPECT_NEAR(auto_exposure(Image(7, 5, glm::vec3(0.8f))), 0.0, kStops);
    EXPECT_NEAR(auto_exposure(Image(7, 5, glm::vec3(1600.0f))), std::log2(0.8 / 1600.0), kStops);
}

TEST(AutoExposure, TakesTheNinetiethPercentile) {
    const Image ramp = test::grey_picture(10, 1, [](std::uint32_t x, std::uint32_t) { return float(x + 1); });
    EXPECT_NEAR(auto_exposure(ramp), std::log2(0.8 / 9.0), kStops);
}

TEST(AutoExposure, FollowsTheScaleOfThePicture) {
    Image picture = test::noise(16, 16, 1);
    const double stops = auto_exposure(picture);
    for (glm::vec3& pixel : picture.pixels)
        pixel *= 1024.0f;
    EXPECT_NEAR(auto_exposure(picture), stops - 10.0, 1e-12);
}

TEST(AutoExposure, IgnoresBlackNegativeAndNonFinitePixels) {
    Image picture(5, 1, glm::vec3(0.0f));
    picture.at(1, 0) = glm::vec3(kNan);
    picture.at(2, 0) = glm::vec3(kInfinity);
    picture.at(3, 0) = glm::vec3(-2.0f);
    EXPECT_EQ(auto_exposure(picture), 0.0);
    picture.at(4, 0) = glm::vec3(0.2f);
    EXPECT_NEAR(auto_exposure(picture), 2.0, kStops);
    EXPECT_EQ(auto_exposure(Image()), 0.0);
}

TEST(ToDisplay, ExposesClampsAndMarksNonFinitePixels) {
    Image picture(3, 1, glm::vec3(0.25f, 5.0f, -1.0f));
    picture.at(1, 0) = glm::vec3(0.0f, kNan, 0.0f);
    picture.at(2, 0) = glm::vec3(kInfinity);
    const Image display = to_display(picture, 1.0);
    EXPECT_EQ(display.at(0, 0), glm::vec3(srgb_encode(0.5f), srgb_encode(1.0f), 0.0f));
    EXPECT_EQ(display.at(1, 0), glm::vec3(1.0f, 0.0f, 1.0f));
    EXPECT_EQ(display.at(2, 0), glm::vec3(1.0f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace utsuri
