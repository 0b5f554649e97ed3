// SPDX-License-Identifier: Apache-2.0
#include "image/ssim.h"

#include "image/colour.h"

#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

/// Float inputs and a float map, everything between in double.
constexpr double kMapRounding = 1e-6;

double constant_ssim(double a, double b) {
    const auto grey = [](double value) {
        return Image(20, 13, glm::vec3(static_cast<float>(value / 255.0)));
    };
    return mean(ssim_map(grey(a), grey(b)));
}

int mirror(int i, int size) {
    while (i < 0 || i >= size)
        i = i < 0 ? -1 - i : 2 * size - 1 - i;
    return i;
}

/// The definition, summed over the window in two dimensions around its mean.
double direct_ssim(const Image& a, const Image& b, int px, int py) {
    const auto sample = [](const Image& image, int x, int y) {
        const auto column = static_cast<std::uint32_t>(mirror(x, static_cast<int>(image.width)));
        const auto row = static_cast<std::uint32_t>(mirror(y, static_cast<int>(image.height)));
        return static_cast<double>(luminance(image.at(column, row)));
    };
    double weights = 0.0, mean_a = 0.0, mean_b = 0.0;
    const auto weight = [](int x, int y) { return std::exp(-(x * x + y * y) / (2.0 * 1.5 * 1.5)); };
    for (int y = -5; y <= 5; ++y) {
        for (int x = -5; x <= 5; ++x) {
            weights += weight(x, y);
            mean_a += weight(x, y) * sample(a, px + x, py + y);
            mean_b += weight(x, y) * sample(b, px + x, py + y);
        }
    }
    mean_a /= weights;
    mean_b /= weights;
    double var_a = 0.0, var_b = 0.0, covariance = 0.0;
    for (int y = -5; y <= 5; ++y) {
        for (int x = -5; x <= 5; ++x) {
            const double da = sample(a, px + x, py + y) - mean_a;
            const double db = sample(b, px + x, py + y) - mean_b;
            var_a += weight(x, y) / weights * da * da;
            var_b += weight(x, y) / weights * db * db;
            covariance += weight(x, y) / weights * da * db;
        }
    }
    return (2 * mean_a * mean_b + 1e-4) * (2 * covariance + 9e-4) /
           ((mean_a * mean_a + mean_b * mean_b + 1e-4) * (var_a + var_b + 9e-4));
}

TEST(Ssim, ConstantPictures) {
    EXPECT_NEAR(constant_ssim(100, 120), 0.983610925, kMapRounding);
    EXPECT_NEAR(constant_ssim(128, 129), 0.999969726, kMapRounding);
    EXPECT_NEAR(constant_ssim(0, 255), 0.000099990, 1e-9);
}

TEST(Ssim, EqualPicturesGiveOne) {
    const Image picture = test::noise(31, 17, 3);
    for (const float value : ssim_map(picture, picture).values)
        EXPECT_FLOAT_EQ(value, 1.0f);
}

TEST(Ssim, AgreesWithTheDefinitionEverywhere) {
    for (const auto& [width, height] : {std::pair{37, 14}, std::pair{3, 2}, std::pair{1, 1}}) {
        const auto w = static_cast<std::uint32_t>(width);
        const auto h = static_cast<std::uint32_t>(height);
        const Image a = test::noise(w, h, 1);
        const Image b = test::noise(w, h, 2);
        const Plane map = ssim_map(a, b);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                EXPECT_NEAR(map.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)),
                            direct_ssim(a, b, x, y), kMapRounding)
                    << x << ' ' << y;
            }
        }
    }
}

TEST(Ssim, IsSymmetric) {
    const Image a = test::noise(20, 20, 5);
    const Image b = test::noise(20, 20, 6);
    EXPECT_EQ(ssim_map(a, b).values, ssim_map(b, a).values);
}

TEST(Ssim, EmptyPictureHasEmptyMap) {
    EXPECT_TRUE(ssim_map(Image(), Image()).values.empty());
}

}  // namespace
}  // namespace utsuri
