// SPDX-License-Identifier: Apache-2.0
#include "image/error_map.h"

#include "base/error.h"
#include "image/cielab.h"
#include "image/colour.h"
#include "image/metrics.h"

#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace utsuri {
namespace {

float lightness(const glm::vec3& coded) {
    const XyzSpace xyz;
    return lab_from_relative_xyz(xyz.from_linear * srgb_decode(coded) / xyz.white).x;
}

TEST(ErrorMap, LightnessRisesLinearly) {
    // Clamping to the gamut anywhere on the scale would bend the line. Float matrices and powers stay within
    // this.
    constexpr float kLightness = 0.01f;
    for (int i = 0; i <= 200; ++i) {
        const float fraction = static_cast<float>(i) / 200.0f;
        EXPECT_NEAR(lightness(error_colour(fraction)), 97.0f * fraction, kLightness) << fraction;
    }
}

TEST(ErrorMap, EndsAndOutliers) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(error_colour(0.0f)[c], 0.0f, 1e-5f);
    EXPECT_EQ(error_colour(-3.0f), error_colour(0.0f));
    EXPECT_EQ(error_colour(9.0f), error_colour(1.0f));
}

TEST(ErrorMap, ScalesByTheMaximumAndMarksNotANumber) {
    Plane errors(4, 1);
    errors.values = {0.0f, 5.0f, std::numeric_limits<float>::infinity(),
                     std::numeric_limits<float>::quiet_NaN()};
    const Image map = error_map(errors, 10.0f);
    EXPECT_EQ(map.at(0, 0), error_colour(0.0f));
    EXPECT_NEAR(lightness(map.at(1, 0)), 48.5f, 0.06f);  // the table has 1024 steps
    EXPECT_EQ(map.at(2, 0), error_colour(1.0f));
    EXPECT_EQ(map.at(3, 0), glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST(LogErrorMap, EqualFactorsAreEqualStepsOfLightness) {
    Plane errors(4, 1);
    errors.values = {0.1f, 1.0f, 10.0f, 100.0f};
    const Image map = log_error_map(errors, 0.1f, 100.0f);
    for (std::uint32_t i = 0; i < 4; ++i) {
        // The table has 1024 steps.
        EXPECT_NEAR(lightness(map.at(i, 0)), 97.0f * static_cast<float>(i) / 3.0f, 0.06f) << i;
    }
}

TEST(LogErrorMap, EndsAndWhatIsLeftOut) {
    Plane errors(5, 1);
    errors.values = {0.0f, 0.05f, std::numeric_limits<float>::infinity(), -1.0f,
                     std::numeric_limits<float>::quiet_NaN()};
    const Image map = log_error_map(errors, 0.1f, 100.0f);
    EXPECT_EQ(map.at(0, 0), error_colour(0.0f));
    EXPECT_EQ(map.at(1, 0), error_colour(0.0f));
    EXPECT_EQ(map.at(2, 0), error_colour(1.0f));
    EXPECT_EQ(map.at(3, 0), kLeftOutColour);
    EXPECT_EQ(map.at(4, 0), glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST(RelativeError, AveragesToTheMetric) {
    const Image a = test::noise(12, 9, 1);
    const Image b = test::noise(12, 9, 2);
    EXPECT_NEAR(mean(relative_error(a, b)), compute_metrics(a, b).mape, 1e-6);
}

TEST(RelativeError, KnownValueAndDamage) {
    Image reference(2, 1, glm::vec3(1.0f));
    Image test(2, 1, glm::vec3(1.0f, 1.505f, 1.0f));
    reference.at(1, 0).x = std::numeric_limits<float>::quiet_NaN();
    const Plane map = relative_error(reference, test);
    EXPECT_NEAR(map.at(0, 0), 0.505 / 1.01 / 3.0, 1e-6);
    EXPECT_TRUE(std::isnan(map.at(1, 0)));
    EXPECT_THROW(static_cast<void>(relative_error(Image(1, 2), Image(2, 1))), InputError);
}

}  // namespace
}  // namespace utsuri
