// SPDX-License-Identifier: Apache-2.0
#include "image/metrics.h"

#include "base/check.h"
#include "base/error.h"
#include "image/colour.h"

#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace utsuri {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Relative: inputs such as 1.1 are rounded to float before their difference is taken.
constexpr double kInputRounding = 3e-7;

Image row(const std::vector<float>& values) {
    return test::grey_picture(static_cast<std::uint32_t>(values.size()), 1,
                              [&](std::uint32_t x, std::uint32_t) { return values[x]; });
}

const MetricSettings kRaw{.normalise = false, .exposure = 0.0};

TEST(Metrics, KnownAnswers) {
    const Metrics metrics = compute_metrics(row({0, 0.5f, 1, 10}), row({0.1f, 0.5f, 1.1f, 8}), nullptr, kRaw);
    EXPECT_NEAR(metrics.mse, 1.005, 1.005 * kInputRounding);
    EXPECT_NEAR(metrics.rel_mse, 0.262474248, 0.27 * kInputRounding);
    EXPECT_NEAR(metrics.mape, 2.574702525, 2.6 * kInputRounding);
    EXPECT_EQ(metrics.max, 2.0);
    EXPECT_EQ(metrics.p999, 2.0);
    EXPECT_EQ(metrics.pixels, 4u);
    EXPECT_EQ(metrics.nonfinite, 0u);
}

TEST(Metrics, ChannelsCountAlike) {
    const Image black(1, 1, glm::vec3(0.0f));
    const Metrics metrics = compute_metrics(black, Image(1, 1, glm::vec3(3.0f, 0.0f, -6.0f)), nullptr, kRaw);
    EXPECT_EQ(metrics.mse, 15.0);
    EXPECT_EQ(metrics.rel_mse, 1500.0);
    EXPECT_EQ(metrics.mape, 300.0);
    EXPECT_EQ(metrics.max, 6.0);
}

TEST(Metrics, NegativeReferencesKeepTheDenominatorPositive) {
    const Metrics metrics = compute_metrics(row({-0.01f}), row({0.99f}), nullptr, kRaw);
    EXPECT_NEAR(metrics.mape, 50.0, 50.0 * kInputRounding);
}

TEST(Metrics, PsnrOfCodeValues) {
    // 20 log10 of 1 + the coding error of two values over one code step.
    constexpr double kDecibels = 2e-3;
    for (const auto& [step, psnr] : {std::pair{1, 48.130804}, std::pair{10, 28.130804}}) {
        std::vector<float> a, b;
        for (int byte = 0; byte < 240; ++byte) {
            a.push_back(srgb_decode(static_cast<float>(byte) / 255.0f));
            b.push_back(srgb_decode(static_cast<float>(byte + step) / 255.0f));
        }
        EXPECT_NEAR(compute_metrics(row(a), row(b), nullptr, kRaw).psnr, psnr, kDecibels);
    }
}

TEST(Metrics, EqualPicturesAgree) {
    const Image picture = test::noise(40, 30, 9);
    const Metrics metrics = compute_metrics(picture, picture);
    EXPECT_EQ(metrics.mse, 0.0);
    EXPECT_EQ(metrics.rel_mse, 0.0);
    EXPECT_EQ(metrics.mape, 0.0);
    EXPECT_EQ(metrics.psnr, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(metrics.ssim, 1.0, 1e-7);
    EXPECT_EQ(metrics.flip, 0.0);
    EXPECT_EQ(metrics.max, 0.0);
    EXPECT_EQ(metrics.pixels, 1200u);
}

TEST(Metrics, NormalisedOnesDoNotDependOnTheUnitOfLight) {
    const auto lit = [](std::uint32_t seed, float factor) {
        Image image = test::noise(24, 20, seed);
        for (glm::vec3& pixel : image.pixels)
            pixel *= factor;
        return image;
    };
    const Metrics once = compute_metrics(lit(1, 1.0f), lit(2, 1.0f));
    for (const float factor : {0x1p-40f, 0x1p50f}) {
        const Metrics other = compute_metrics(lit(1, factor), lit(2, factor));
        EXPECT_DOUBLE_EQ(other.mse, once.mse);
        EXPECT_DOUBLE_EQ(other.rel_mse, once.rel_mse);
        EXPECT_DOUBLE_EQ(other.mape, once.mape);
        EXPECT_DOUBLE_EQ(other.max, once.max);
        EXPECT_DOUBLE_EQ(other.p999, once.p999);
        // Exposures come from logarithms.
        EXPECT_NEAR(other.psnr, once.psnr, 1e-5);
        EXPECT_NEAR(other.ssim, once.ssim, 1e-5);
        EXPECT_NEAR(other.flip, once.flip, 1e-5);
    }
}

TEST(Metrics, NormalisationIsTheMeanLuminance) {
    // Mean luminance 2, so that a difference of 1 counts 0.5.
    const Metrics metrics = compute_metrics(row({1, 3}), row({2, 3}));
    EXPECT_NEAR(metrics.mse, 0.125, 0.125 * kInputRounding);
    EXPECT_NEAR(metrics.max, 0.5, 0.5 * kInputRounding);
    EXPECT_EQ(normalisation(row({0, 0})), 1.0);
    EXPECT_EQ(normalisation(row({-1, 0})), 1.0);
    EXPECT_EQ(normalisation(row({kNan, kInfinity})), 1.0);
    EXPECT_EQ(normalisation(Image()), 1.0);
}

TEST(Metrics, PercentileIsTheNearestRank) {
    std::vector<float> test(2000, 0.25f);
    const Image reference = row(std::vector<float>(2000, 0.0f));
    test[17] = test[1800] = 7.0f;  // two of 2000 lie above the percentile
    EXPECT_EQ(compute_metrics(reference, row(test), nullptr, kRaw).p999, 0.25);
    test[5] = 6.0f;
    EXPECT_EQ(compute_metrics(reference, row(test), nullptr, kRaw).p999, 6.0);
    EXPECT_EQ(compute_metrics(reference, row(test), nullptr, kRaw).max, 7.0);
}

TEST(Metrics, PixelsThatAreNotFiniteAreCountedAndLeftOut) {
    const std::vector<float> reference{0, kNan, 1, 10, 2, 0.5f};
    const std::vector<float> test{0.1f, 3, 1.1f, 8, kInfinity, 0.5f};
    const Metrics metrics = compute_metrics(row(reference), row(test), nullptr, kRaw);
    EXPECT_EQ(metrics.nonfinite, 2u);
    EXPECT_EQ(metrics.pixels, 4u);
    EXPECT_NEAR(metrics.mse, 1.005, 1.005 * kInputRounding);
    EXPECT_NEAR(metrics.mape, 2.574702525, 2.6 * kInputRounding);
    EXPECT_TRUE(std::isfinite(metrics.psnr));
    EXPECT_TRUE(std::isfinite(metrics.ssim));
    EXPECT_TRUE(std::isfinite(metrics.flip));
    const Metrics none = compute_metrics(row({kNan, 1}), row({1, kNan}));
    EXPECT_EQ(none.pixels, 0u);
    EXPECT_EQ(none.nonfinite, 2u);
    EXPECT_TRUE(std::isnan(none.mse));
}

TEST(Metrics, MaskSelectsPixels) {
    const Image reference = row({0, 7, 0.5f, 1, kNan, 10, kNan});
    const Image test = row({0.1f, 0, 0.5f, 1.1f, 1, 8, 1});
    const Mask mask{1, 0, 255, 1, 0, 1, 1};
    const Metrics metrics = compute_metrics(reference, test, &mask, kRaw);
    EXPECT_EQ(metrics.pixels, 4u);
    EXPECT_EQ(metrics.nonfinite, 1u);
    EXPECT_NEAR(metrics.mse, 1.005, 1.005 * kInputRounding);
}

TEST(Metrics, MaskAveragesTheMapsOfTheWholeFrame) {
    const Image a = test::noise(16, 16, 1);
    const Image b = test::noise(16, 16, 2);
    const PerceptualMaps maps = compute_perceptual_maps(a, b);
    Mask mask(256, 0);
    mask[37] = mask[200] = 1;
    const Metrics metrics = compute_metrics(a, b, &maps, &mask);
    const auto average = [](const Plane& map) {
        return 0.5 * (static_cast<double>(map.values[37]) + static_cast<double>(map.values[200]));
    };
    EXPECT_DOUBLE_EQ(metrics.ssim, average(maps.ssim));
    EXPECT_DOUBLE_EQ(metrics.flip, average(maps.flip));
    EXPECT_DOUBLE_EQ(compute_metrics(a, b).flip, compute_metrics(a, b, &maps, nullptr).flip);
    EXPECT_NEAR(compute_metrics(a, b).flip, mean(maps.flip), 1e-12);
}

TEST(Metrics, WithoutMapsThePerceptualOnesStayUnknown) {
    const Metrics metrics = compute_metrics(row({1}), row({2}), nullptr, nullptr);
    EXPECT_TRUE(std::isnan(metrics.ssim));
    EXPECT_TRUE(std::isnan(metrics.flip));
    EXPECT_NEAR(metrics.mse, 1.0, kInputRounding);
}

TEST(Metrics, EmptySelectionMeasuresNothing) {
    const Mask mask{0, 0};
    for (const Metrics& metrics :
         {compute_metrics(row({1, 2}), row({2, 1}), &mask), compute_metrics(Image(), Image())}) {
        EXPECT_EQ(metrics.pixels, 0u);
        for (const double value : {metrics.mse, metrics.rel_mse, metrics.mape, metrics.psnr, metrics.ssim,
                                   metrics.flip, metrics.max, metrics.p999}) {
            EXPECT_TRUE(std::isnan(value));
        }
    }
}

TEST(Metrics, LowDynamicRangeFlipOnRequest) {
    const Image black(8, 8, glm::vec3(0.0f));
    const Image white(8, 8, glm::vec3(4.0f));
    const MetricSettings settings{.exposure = -2.0, .flip_hdr = false};
    EXPECT_NEAR(compute_metrics(black, white, nullptr, settings).flip, 0.967388, 1e-4);
}

TEST(Metrics, RejectsWhatCannotBeCompared) {
    try {
        static_cast<void>(compute_metrics(Image(3, 2), Image(2, 3)));
        FAIL() << "sizes differ";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("3 x 2"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("2 x 3"), std::string::npos) << error.what();
    }
    EXPECT_THROW(static_cast<void>(compute_metrics(row({1}), row({1}), nullptr, {.epsilon = 0.0})),
                 UsageError);
    const Mask wrong(3, 1);
    EXPECT_THROW(static_cast<void>(compute_metrics(row({1}), row({1}), &wrong)), CheckFailure);
}

}  // namespace
}  // namespace utsuri
