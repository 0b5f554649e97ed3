// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/reflection_errors.h"

#include "compare/comparison/reflection_pictures.h"

#include "image/error_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace utsuri {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Plane row(std::vector<float> values) {
    Plane plane(static_cast<std::uint32_t>(values.size()), 1);
    plane.values = std::move(values);
    return plane;
}

TEST(ReflectionErrorSummary, RanksAreThoseOfMirrorPixels) {
    ReflectionErrors errors;
    errors.predicted = Plane(121, 1, -1.0f);
    errors.measured = Plane(121, 1, -1.0f);
    // 1 to 100 in an order that is not theirs: 2 is a generator of the numbers below 101.
    for (std::size_t i = 0, value = 1; i < 100; ++i, value = value * 2 % 101) {
        errors.predicted.values[i] = static_cast<float>(value);
        errors.measured.values[i] = 0.5f * static_cast<float>(value);
    }
    const ReflectionErrorSummary summary = summarise(errors);
    EXPECT_EQ(summary.pixels, 100u);
    EXPECT_EQ(summary.traced, 0u);
    EXPECT_EQ(summary.predicted.median, 50.0);
    EXPECT_EQ(summary.predicted.p95, 95.0);
    EXPECT_EQ(summary.measured.median, 25.0);
    EXPECT_EQ(summary.measured.p95, 47.5);
    EXPECT_EQ(summary.exceeded, 0.0);
}

TEST(ReflectionErrorSummary, CountsWhatIsOffByMoreThanPredicted) {
    ReflectionErrors errors;
    errors.predicted = row({-1.0f, 1.0f, 2.0f, kInfinity, 0.0f});
    errors.measured = row({-1.0f, 1.0f, 2.5f, 50.0f, 0.0f});
    errors.traced = row({-1.0f, 0.0f, 0.0f, 0.0f, 1.0f});
    const ReflectionErrorSummary summary = summarise(errors);
    EXPECT_EQ(summary.exceeded, 0.25);
    EXPECT_EQ(summary.traced, 1u);
    EXPECT_EQ(summary.predicted.median, 1.0);
    EXPECT_EQ(summary.predicted.p95, std::numeric_limits<double>::infinity());
}

TEST(ReflectionErrorSummary, WithoutAMirrorThereIsNothing) {
    ReflectionErrors errors;
    errors.predicted = errors.measured = row({-1.0f, -1.0f});
    const ReflectionErrorSummary summary = summarise(errors);
    EXPECT_EQ(summary.pixels, 0u);
    EXPECT_EQ(summary.predicted.p95, 0.0);
    EXPECT_EQ(summary.exceeded, 0.0);
}

TEST(ReflectionPictures, ShareOneScale) {
    const Image picture =
        displacement_picture(row({-1.0f, 0.0f, kLeastDisplacement, kMostDisplacement, kInfinity}));
    EXPECT_EQ(picture.at(0, 0), kLeftOutColour);
    EXPECT_EQ(picture.at(1, 0), error_colour(0.0f));
    EXPECT_EQ(picture.at(2, 0), error_colour(0.0f));
    EXPECT_EQ(picture.at(3, 0), error_colour(1.0f));
    EXPECT_EQ(picture.at(4, 0), error_colour(1.0f));
}

TEST(ReflectionPictures, TracedPixelsStandOut) {
    const Image picture = traced_picture(row({-1.0f, 0.0f, 1.0f}));
    EXPECT_EQ(picture.at(0, 0), kLeftOutColour);
    EXPECT_EQ(picture.at(1, 0), looked_up_colour());
    EXPECT_EQ(picture.at(2, 0), traced_colour());
}

}  // namespace
}  // namespace utsuri
