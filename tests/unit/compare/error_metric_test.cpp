// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/error_metric.h"

#include "base/error.h"
#include "image/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

const MetricSettings kRaw{.normalise = false, .exposure = 0.0};

/// A reference that is noisy about the truth 1, and its half, noisy about itself: all four combinations of
/// signs occur equally often, so that every mean below is what it is for independent noise.
struct NoisyReference {
    Image whole{4, 4};
    Image half{4, 4};
    Metrics noise;

    explicit NoisyReference(float sigma) {
        for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
            whole.pixels[i] = glm::vec3(1.0f + (i % 2 == 0 ? sigma : -sigma));
            half.pixels[i] = whole.pixels[i] + glm::vec3(i / 2 % 2 == 0 ? sigma : -sigma);
        }
        noise = compute_metrics(whole, half, nullptr, kRaw);
    }
    /// Of a picture that is wrong by `error` everywhere.
    [[nodiscard]] Metrics measure(float error) const {
        return compute_metrics(whole, Image(4, 4, glm::vec3(1.0f + error)), nullptr, kRaw);
    }
};

TEST(ErrorMetric, NoiseOfTheReferenceIsSubtractedFromTheMeanSquare) {
    // 1 + sigma, 1 + error and their squares are exact in binary.
    const NoisyReference reference(0.125f);
    const ErrorMetric& mse = parse_error_metric("mse");
    EXPECT_EQ(reference.noise.mse, 0.125 * 0.125);
    EXPECT_EQ(reference.measure(0.5f).mse, 0.5 * 0.5 + 0.125 * 0.125);
    EXPECT_EQ(error_beyond_noise(mse, reference.measure(0.5f), reference.noise), 0.5 * 0.5);
}

TEST(ErrorMetric, NoiseIsSubtractedFromRelMseToItsFirstOrder) {
    // What remains of (error - n)^2 / ((1 + n)^2 + epsilon) is the second order of n in the other terms, less
    // than 4 error n^2 + 3 error^2 n^2.
    const float sigma = 0.03125f;
    const float error = 0.5f;
    const NoisyReference reference(sigma);
    const double exact = 0.25 / (1.0 + kRaw.epsilon);
    const double without =
        error_beyond_noise(parse_error_metric("rel_mse"), reference.measure(error), reference.noise);
    const double remainder = static_cast<double>((4.0f * error + 3.0f * error * error) * sigma * sigma);
    EXPECT_NEAR(without, exact, remainder);
    EXPECT_GT(reference.noise.rel_mse, 0.9 * static_cast<double>(sigma * sigma));
}

TEST(ErrorMetric, OthersAreTakenAsMeasured) {
    const NoisyReference reference(0.125f);
    const Metrics measured = reference.measure(0.5f);
    for (const char* name : {"mape", "max", "p999"}) {
        const ErrorMetric& metric = parse_error_metric(name);
        EXPECT_EQ(error_beyond_noise(metric, measured, reference.noise), measured.*metric.value) << name;
    }
}

TEST(ErrorMetric, NothingIsTakenToBeSmallerThanTheNoise) {
    const NoisyReference reference(0.125f);
    const ErrorMetric& mse = parse_error_metric("mse");
    const ErrorMetric& mape = parse_error_metric("mape");
    // The truth itself measures as the noise, and so does what is wrong by less than the noise.
    EXPECT_EQ(error_beyond_noise(mse, reference.measure(0.0f), reference.noise), reference.noise.mse);
    EXPECT_EQ(error_beyond_noise(mse, reference.measure(0.0625f), reference.noise), reference.noise.mse);
    EXPECT_EQ(error_beyond_noise(mape, reference.measure(0.0f), reference.noise), 2.0 * reference.noise.mape);
    // Either way the least error is one that measures as twice the noise.
    EXPECT_EQ(least_error(mse, reference.noise) + reference.noise.mse, 2.0 * reference.noise.mse);
    EXPECT_EQ(least_error(mape, reference.noise), 2.0 * reference.noise.mape);
}

TEST(ErrorMetric, WhatWasNotMeasuredStaysUnknown) {
    for (const ErrorMetric& metric : error_metrics()) {
        EXPECT_TRUE(std::isnan(error_beyond_noise(metric, Metrics(), NoisyReference(0.125f).noise)));
    }
}

TEST(ErrorMetric, NamesAreThoseOfCompareJson) {
    EXPECT_THAT(error_metric_names(), testing::ElementsAre("rel_mse", "mse", "mape", "flip", "p999", "max"));
    try {
        parse_error_metric("psnr");
        FAIL() << "no error";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("'psnr'"));
        EXPECT_THAT(error.what(), testing::HasSubstr("rel_mse, mse"));
    }
}

}  // namespace
}  // namespace utsuri
