// SPDX-License-Identifier: Apache-2.0
#include "image/colour.h"

#include "image/cielab.h"

#include <gtest/gtest.h>

namespace utsuri {
namespace {

/// A power, a product and a sum, each rounded to float.
constexpr float kCodingError = 3e-7f;

TEST(Colour, LuminanceOfWhiteIsOne) {
    EXPECT_NEAR(luminance(glm::vec3(1.0f)), 1.0f, 1.2e-7f);
    EXPECT_FLOAT_EQ(luminance({0.0f, 2.0f, 0.0f}), 1.4304f);
}

TEST(Colour, SrgbKnownValues) {
    EXPECT_EQ(srgb_encode(0.0f), 0.0f);
    EXPECT_NEAR(srgb_encode(1.0f), 1.0f, kCodingError);
    EXPECT_NEAR(srgb_encode(0.5f), 0.7353569831f, kCodingError);
    EXPECT_NEAR(srgb_decode(0.5f), 0.2140411405f, kCodingError);
    EXPECT_NEAR(srgb_encode(0.001f), 0.01292f, kCodingError);
    EXPECT_NEAR(srgb_encode(-0.001f), -0.01292f, kCodingError);
}

TEST(Colour, SrgbRoundTripOfEveryByte) {
    for (int byte = 0; byte < 256; ++byte) {
        const float coded = static_cast<float>(byte) / 255.0f;
        EXPECT_NEAR(srgb_encode(srgb_decode(coded)), coded, kCodingError) << byte;
    }
}

TEST(Colour, DisplayCodeScalesAndClampsBeyondFloatRange) {
    EXPECT_EQ(display_code(glm::vec3(3e38f), 1e30), glm::vec3(srgb_encode(1.0f)));
    EXPECT_EQ(display_code(glm::vec3(-1.0f), 1.0), glm::vec3(0.0f));
    EXPECT_NEAR(display_code(glm::vec3(1e-38f), 0.5e38).x, srgb_encode(0.5f), kCodingError);
}

TEST(Colour, XyzOfPrimariesIsThatOfTheFlipPapers) {
    const XyzSpace xyz;
    EXPECT_NEAR(xyz.white.x, 0.950428545f, 1e-6f);
    EXPECT_NEAR(xyz.white.z, 1.088900371f, 1e-6f);
    EXPECT_NEAR(xyz.from_linear[0][0], 10135552.0 / 24577794.0, 1e-5);
    EXPECT_NEAR(xyz.from_linear[1][1], 8788810.0 / 12288897.0, 1e-5);
    EXPECT_NEAR(xyz.from_linear[2][2], 70074185.0 / 73733382.0, 1e-5);
}

TEST(Colour, LabRoundTripAndKnownPoints) {
    const glm::vec3 white = lab_from_relative_xyz(glm::vec3(1.0f));
    EXPECT_NEAR(white.x, 100.0f, 1e-4f);
    EXPECT_NEAR(lab_from_relative_xyz(glm::vec3(0.18f)).x, 49.4961f, 1e-3f);
    // Below the knee L* is 903.3 Y (CIE 15: (29/3)^3).
    EXPECT_NEAR(lab_from_relative_xyz(glm::vec3(0.001f)).x, 0.9032963f, 1e-5f);
    const glm::vec3 sample(0.3f, 0.004f, 0.9f);
    const glm::vec3 back = relative_xyz_from_lab(lab_from_relative_xyz(sample));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(back[c], sample[c], 1e-6f);
}

}  // namespace
}  // namespace utsuri
