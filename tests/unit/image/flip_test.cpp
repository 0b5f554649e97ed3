// SPDX-License-Identifier: Apache-2.0
#include "image/flip.h"

#include "base/error.h"
#include "image/colour.h"
#include "image/flip_band.h"

#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace utsuri {
namespace {

constexpr std::uint32_t kSize = 64;
/// Of the recorded answers, which were made with the authors' C++ code in float.
constexpr double kKnown = 1e-4;

Image constant(const glm::vec3& linear) {
    return Image(kSize, kSize, linear);
}
Image coded_grey(float coded) {
    return constant(glm::vec3(srgb_decode(coded)));
}

float largest(const Plane& map) {
    return *std::max_element(map.values.begin(), map.values.end());
}

void expect_within_unit_range(const Plane& map) {
    for (const float value : map.values) {
        ASSERT_GE(value, 0.0f);
        ASSERT_LE(value, 1.0f);
    }
}

/// White from column `first` on, black before.
Image right_half(std::uint32_t first) {
    return test::grey_picture(kSize, kSize,
                              [&](std::uint32_t x, std::uint32_t) { return x >= first ? 1.0f : 0.0f; });
}

/// Three stops a 24 columns: 2^((x - 32) / 8).
Image ramp(float factor) {
    return test::grey_picture(kSize, kSize, [&](std::uint32_t x, std::uint32_t) {
        return factor * std::exp2((static_cast<float>(x) - 32.0f) / 8.0f);
    });
}

TEST(FlipLdr, LargestColourDifference) {
    EXPECT_NEAR(largest_hyab(), 203.30166, 1e-3);
    EXPECT_NEAR(std::pow(largest_hyab(), 0.7f), 41.276099, 1e-4);
}

TEST(FlipLdr, ConstantPairs) {
    EXPECT_NEAR(mean(flip_ldr(constant(glm::vec3(0.0f)), constant(glm::vec3(1.0f)))), 0.967388, kKnown);
    EXPECT_NEAR(mean(flip_ldr(coded_grey(0.5f), coded_grey(0.6f))), 0.285063, kKnown);
    EXPECT_NEAR(mean(flip_ldr(coded_grey(0.25f), coded_grey(0.75f))), 0.895295, kKnown);
    EXPECT_NEAR(mean(flip_ldr(constant({1, 0, 0}), constant({0, 1, 0}))), 0.986665, kKnown);
    EXPECT_NEAR(mean(flip_ldr(constant({0, 1, 0}), constant({0, 0, 1}))), 1.0, kKnown);
}

TEST(FlipLdr, MovedEdge) {
    const Plane by_one = flip_ldr(right_half(32), right_half(33));
    EXPECT_NEAR(mean(by_one), 0.051732, kKnown);
    EXPECT_NEAR(largest(by_one), 0.772917, kKnown);
    const Plane by_four = flip_ldr(right_half(32), right_half(36));
    EXPECT_NEAR(mean(by_four), 0.126321, kKnown);
    EXPECT_NEAR(largest(by_four), 0.986783, kKnown);
}

TEST(FlipLdr, OneWhitePixel) {
    Image dotted = coded_grey(0.5f);
    dotted.at(32, 32) = glm::vec3(1.0f);
    const Plane map = flip_ldr(coded_grey(0.5f), dotted);
    EXPECT_NEAR(mean(map), 0.001055, kKnown);
    EXPECT_NEAR(largest(map), 0.380198, kKnown);
    EXPECT_EQ(map.at(0, 0), 0.0f);
}

TEST(FlipLdr, CheckerAgainstItsMean) {
    const Image checker = test::grey_picture(
        kSize, kSize, [](std::uint32_t x, std::uint32_t y) { return (x + y) % 2 == 0 ? 0.0f : 1.0f; });
    const Plane map = flip_ldr(constant(glm::vec3(0.5f)), checker);
    EXPECT_NEAR(mean(map), 0.004204, kKnown);
    EXPECT_NEAR(largest(map), 0.515740, kKnown);
}

TEST(FlipLdr, ExposureActsAsAScale) {
    const Image a = test::noise(20, 20, 1);
    const Image b = test::noise(20, 20, 2);
    Image a4 = a;
    Image b4 = b;
    for (glm::vec3& pixel : a4.pixels)
        pixel *= 4.0f;
    for (glm::vec3& pixel : b4.pixels)
        pixel *= 4.0f;
    EXPECT_EQ(flip_ldr(a, b, {}, 2.0).values, flip_ldr(a4, b4).values);
}

TEST(FlipHdr, ExposuresOfARamp) {
    const FlipExposures exposures = flip_exposures(ramp(1.0f));
    EXPECT_NEAR(exposures.start, -2.7917, kKnown);
    EXPECT_NEAR(exposures.stop, 1.0833, kKnown);
    EXPECT_EQ(exposures.count, 4);
}

TEST(FlipHdr, Ramp) {
    const Plane brighter = flip_hdr(ramp(1.0f), ramp(1.1f));
    EXPECT_NEAR(mean(brighter), 0.121643, kKnown);
    EXPECT_NEAR(largest(brighter), 0.140153, kKnown);
    Image dotted = ramp(1.0f);
    dotted.at(32, 32) = glm::vec3(1000.0f);
    const Plane firefly = flip_hdr(ramp(1.0f), dotted);
    EXPECT_NEAR(mean(firefly), 0.001382, kKnown);
    EXPECT_NEAR(largest(firefly), 0.472778, kKnown);
}

TEST(FlipHdr, IsIndependentOfTheScaleOfLight) {
    const Plane map = flip_hdr(ramp(1.0f), ramp(1.1f));
    const auto scaled = [](Image image, float factor) {
        for (glm::vec3& pixel : image.pixels)
            pixel *= factor;
        return image;
    };
    for (const float factor : {0x1p-60f, 0x1p60f}) {
        const Plane other = flip_hdr(scaled(ramp(1.0f), factor), scaled(ramp(1.1f), factor));
        for (std::size_t i = 0; i < map.values.size(); ++i)
            ASSERT_NEAR(other.values[i], map.values[i], 1e-5);
    }
}

TEST(FlipHdr, DoesNotDependOnTheThreads) {
    const Image a = test::noise(33, 200, 1);
    const Image b = test::noise(33, 200, 2);
    const Plane one = flip_hdr(a, b, {.threads = 1});
    EXPECT_EQ(flip_hdr(a, b, {.threads = 3}).values, one.values);
    expect_within_unit_range(one);
}

TEST(FlipHdr, BandsJoinWithoutASeam) {
    // A picture that is 64 rows high is one band, twice that two: rows far from the added part must not
    // change.
    const auto stripes = [](std::uint32_t rows, float dot) {
        Image image = test::grey_picture(32, rows, [](std::uint32_t x, std::uint32_t y) {
            return 0.5f + 0.4f * std::sin(0.7f * static_cast<float>(x) + 0.3f * static_cast<float>(y));
        });
        image.at(16, 62) = glm::vec3(dot);
        return image;
    };
    const Plane tall = flip_ldr(stripes(128, 0.1f), stripes(128, 0.9f));
    // The same picture upside down puts the dot into the other band, at its edge.
    const auto flipped = [](Image image) {
        for (std::uint32_t y = 0; y < image.height / 2; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                std::swap(image.at(x, y), image.at(x, image.height - 1 - y));
            }
        }
        return image;
    };
    const Plane turned = flip_ldr(flipped(stripes(128, 0.1f)), flipped(stripes(128, 0.9f)));
    EXPECT_GT(tall.at(16, 64), 0.05f);
    for (std::uint32_t y = 0; y < 128; ++y) {
        // Other order of the same float sums.
        for (std::uint32_t x = 0; x < 32; ++x)
            EXPECT_NEAR(tall.at(x, y), turned.at(x, 127 - y), 1e-3);
    }
}

TEST(FlipHdr, DegenerateReferences) {
    const Image black = constant(glm::vec3(0.0f));
    EXPECT_EQ(mean(flip_hdr(black, black)), 0.0);
    EXPECT_GT(mean(flip_hdr(black, constant(glm::vec3(1e-20f)))), 0.5);

    Image spot = black;  // its median is zero
    spot.at(5, 5) = glm::vec3(3.0f);
    EXPECT_EQ(mean(flip_hdr(spot, spot)), 0.0);
    const Plane lost = flip_hdr(spot, black);
    expect_within_unit_range(lost);
    EXPECT_GT(lost.at(5, 5), 0.3f);

    const FlipExposures uniform = flip_exposures(constant(glm::vec3(2.0f)));
    EXPECT_EQ(uniform.start, uniform.stop);
    EXPECT_EQ(uniform.count, 2);
    expect_within_unit_range(flip_hdr(constant(glm::vec3(2.0f)), spot));

    EXPECT_TRUE(flip_hdr(Image(), Image()).values.empty());
    EXPECT_EQ(flip_hdr(Image(1, 1, glm::vec3(1.0f)), Image(1, 1, glm::vec3(1.0f))).values[0], 0.0f);
}

TEST(FlipHdr, ExtremeRangeIsCutAtTwentyFourStops) {
    Image picture = constant(glm::vec3(1e-35f));
    picture.at(0, 0) = glm::vec3(1e35f);
    const FlipExposures exposures = flip_exposures(picture);
    EXPECT_DOUBLE_EQ(exposures.stop - exposures.start, 24.0);
    EXPECT_EQ(exposures.count, 24);
    expect_within_unit_range(flip_hdr(picture, constant(glm::vec3(3e38f))));
}

TEST(FlipHdr, PixelsThatAreNotFiniteDoNotSpread) {
    Image damaged = ramp(1.0f);
    damaged.at(10, 10) = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    damaged.at(50, 20) = glm::vec3(std::numeric_limits<float>::infinity());
    damaged.at(30, 40) = glm::vec3(0.0f, -std::numeric_limits<float>::infinity(), 0.0f);
    EXPECT_EQ(mean(flip_hdr(ramp(1.0f), damaged)), 0.0);
    EXPECT_EQ(mean(flip_hdr(damaged, ramp(1.0f))), 0.0);
    expect_within_unit_range(flip_hdr(ramp(1.1f), damaged));
}

TEST(FlipSettings, RejectsImpossibleViewingDistances) {
    for (const double wrong : {0.0, -1.0, 1e6, std::nan("")}) {
        EXPECT_THROW(static_cast<void>(flip_ldr(ramp(1), ramp(1), {.pixels_per_degree = wrong})), UsageError);
    }
    for (const double edge : {4.0, 1000.0}) {
        expect_within_unit_range(flip_ldr(Image(9, 9, glm::vec3(0.2f)), test::noise(9, 9, 4),
                                          {.pixels_per_degree = edge, .threads = 1}));
    }
}

}  // namespace
}  // namespace utsuri
