// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/lobe_albedo.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace utsuri {
namespace {

/// References have six digits; the quadrature is of 987 points.
constexpr double kQuadrature = 5e-4;

struct Split {
    double alpha, mu, constant, schlick;
};

// references.md A3.5: Schlick's split of the albedo, height-correlated Smith masking.
TEST(LobeAlbedo, MatchesReferences) {
    for (const Split& s : {Split{0.1, 0.5, 0.937066, 0.032139}, Split{0.1, 0.1, 0.582543, 0.300912},
                           Split{0.25, 0.5, 0.834916, 0.022347}, Split{0.25, 0.1, 0.751930, 0.139692},
                           Split{0.5, 1.0, 0.687802, 0.000047}, Split{0.5, 0.5, 0.688101, 0.010150},
                           Split{0.5, 0.1, 0.798685, 0.061420}, Split{1.0, 0.5, 0.447705, 0.002989},
                           Split{1.0, 0.1, 0.736344, 0.023867}}) {
        SCOPED_TRACE(testing::Message() << "alpha " << s.alpha << ", cosine " << s.mu);
        const interop::LobeAlbedo found = lobe_albedo(s.alpha, s.mu);
        EXPECT_NEAR(static_cast<double>(found.constant), s.constant, kQuadrature);
        EXPECT_NEAR(static_cast<double>(found.schlick), s.schlick, kQuadrature);
    }
}

// alpha = 1: E(mu) = 1 - mu ln(1 + 1 / mu), exactly.
TEST(LobeAlbedo, MatchesTheClosedFormOfTheWidestLobe) {
    for (const double mu : {0.02, 0.1, 0.3, 0.7, 1.0}) {
        const interop::LobeAlbedo found = lobe_albedo(1.0, mu);
        EXPECT_NEAR(static_cast<double>(found.constant + found.schlick), 1.0 - mu * std::log(1.0 + 1.0 / mu),
                    kQuadrature);
    }
}

// Seen along the normal, light at the angle t meets the half vector at t / 2: the mean of (1 - cos(t / 2))^5
// over 2 sin t cos t dt, by Simpson's rule.
TEST(LobeAlbedo, LosesOfLambertsLightWhatSchlickTakes) {
    constexpr int kSteps = 1000;
    const double width = std::acos(0.0) / kSteps;
    double expected = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = i * width;
        const double weight = i == 0 || i == kSteps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        expected += weight * width / 3.0 * std::pow(1.0 - std::cos(0.5 * t), 5.0) * std::sin(2.0 * t);
    }
    EXPECT_NEAR(static_cast<double>(lobe_albedo(0.3, 1.0).lost), expected, 1e-3 * expected);
}

TEST(LobeAlbedo, NeverGains) {
    for (const interop::LobeAlbedo& entry : lobe_albedo_table()) {
        EXPECT_GE(entry.constant, 0.0f);
        EXPECT_GE(entry.schlick, 0.0f);
        EXPECT_LE(entry.constant + entry.schlick, 1.0f);
        EXPECT_GE(entry.lost, 0.0f);
        EXPECT_LE(entry.lost, 1.0f);
    }
}

// Half way between entries, where linear interpolation is worst.
TEST(LobeAlbedo, TableIsFineEnough) {
    constexpr double kInterpolation = 5e-3;
    constexpr double kNarrowLobesAtGrazingAngles = 2e-2;
    constexpr std::uint32_t kSize = interop::LOBE_ALBEDO_SIZE;
    const auto table = lobe_albedo_table();
    const auto whole = [](const interop::LobeAlbedo& entry) {
        return static_cast<double>(entry.constant) + static_cast<double>(entry.schlick);
    };
    for (std::uint32_t row = 0; row + 1 < kSize; ++row) {
        for (std::uint32_t column = 0; column + 1 < kSize; ++column) {
            const std::size_t entry = std::size_t{row} * kSize + column;
            const double mean = 0.25 * (whole(table[entry]) + whole(table[entry + 1]) +
                                        whole(table[entry + kSize]) + whole(table[entry + kSize + 1]));
            const double roughness = (row + 0.5) / (kSize - 1);
            const double root_mu = (column + 0.5) / (kSize - 1);
            // Roughness under 0.03 is a mirror's.
            if (roughness < 0.05) continue;
            const double error =
                std::abs(mean - whole(lobe_albedo(roughness * roughness, root_mu * root_mu)));
            EXPECT_LE(error, roughness > 0.15 ? kInterpolation : kNarrowLobesAtGrazingAngles)
                << "roughness " << roughness << ", cosine " << root_mu * root_mu;
        }
    }
}

// lost_under_lobe() in kernels/light/lobe_albedo.glsl reads the first row alone.
TEST(LobeAlbedo, LosesTheSameWhateverTheWidthOfTheLobe) {
    constexpr std::uint32_t kSize = interop::LOBE_ALBEDO_SIZE;
    const auto& table = lobe_albedo_table();
    for (std::uint32_t i = 0; i < kSize * kSize; ++i)
        EXPECT_EQ(table[i].lost, table[i % kSize].lost) << "entry " << i;
}

}  // namespace
}  // namespace utsuri
