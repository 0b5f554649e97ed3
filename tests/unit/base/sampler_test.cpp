// SPDX-License-Identifier: Apache-2.0
#include "base/sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace utsuri {
namespace {

constexpr std::uint32_t kSeeds[] = {0u, 1u, 0x5bd1e995u, 0xffffffffu};

std::uint32_t reversed(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit)
        result |= ((x >> bit) & 1u) << (31 - bit);
    return result;
}

/// x with its lowest `bits` bits only.
std::uint32_t low_bits(std::uint32_t x, int bits) {
    return bits == 32 ? x : x & ((1u << bits) - 1u);
}

/// How often each of the 2^bits boxes of size 2^-columns x 2^-(bits - columns) holds one of the points.
std::vector<int> box_counts(const std::vector<glm::uvec2>& points, int bits, int columns) {
    std::vector<int> counts(std::size_t{1} << bits, 0);
    for (const glm::uvec2& point : points) {
        const std::uint64_t column = std::uint64_t{point.x} >> (32 - columns);
        const std::uint64_t row = std::uint64_t{point.y} >> (32 - (bits - columns));
        ++counts[(column << (bits - columns)) | row];
    }
    return counts;
}

// Expects that 2^bits points have exactly one in each elementary interval: a (0, bits, 2)-net in base 2.
void expect_net(const std::vector<glm::uvec2>& points, int bits) {
    ASSERT_EQ(points.size(), std::size_t{1} << bits);
    for (int columns = 0; columns <= bits; ++columns) {
        for (const int count : box_counts(points, bits, columns)) {
            ASSERT_EQ(count, 1) << "2^" << bits << " points, boxes of width 2^-" << columns;
        }
    }
}

TEST(Sampler, HashHasTheKnownAnswersOfPcg) {
    // Jarzynski and Olano, "Hash functions for GPU rendering", 2020, the 32-bit pcg hash of 0, 1, 2.
    EXPECT_EQ(hash(0), 0x07bb2fe2u);
    EXPECT_EQ(hash(1), 0xa8beea3cu);
    EXPECT_EQ(hash(2), 0x7a7ecc88u);
}

TEST(Sampler, HashIsInjective) {
    // 2^20 values of a random function would hold about 2^40 / 2^33 = 128 equal pairs.
    std::vector<std::uint32_t> values;
    for (std::uint32_t x = 0; x < 1u << 20; ++x)
        values.push_back(hash(x * 0x9e3779b1u));
    std::sort(values.begin(), values.end());
    EXPECT_EQ(std::adjacent_find(values.begin(), values.end()), values.end());
}

TEST(Sampler, SobolFollowsTheGeneratorMatrices) {
    // The first matrix is the identity; column j of the second is row j of Pascal's triangle modulo 2.
    for (int j = 0; j < 32; ++j) {
        std::uint32_t pascal = 0;
        for (int i = 0; i <= j; ++i) {
            // C(j, i) is odd exactly where the bits of i are among those of j (Lucas).
            if ((i & j) == i) pascal |= 1u << i;
        }
        const glm::uvec2 point = sobol_2d(1u << j);
        EXPECT_EQ(point.x, reversed(1u << j)) << j;
        EXPECT_EQ(point.y, reversed(pascal)) << j;
    }
}

TEST(Sampler, SobolIsLinearOverBits) {
    EXPECT_EQ(sobol_2d(0), glm::uvec2(0u));
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const std::uint32_t a = hash(i);
        const std::uint32_t b = hash(i + 1000000);
        EXPECT_EQ(sobol_2d(a ^ b), sobol_2d(a) ^ sobol_2d(b));
    }
}

TEST(Sampler, SobolPrefixesAreNets) {
    for (int bits = 0; bits <= 12; ++bits) {
        std::vector<glm::uvec2> points;
        for (std::uint32_t i = 0; i < 1u << bits; ++i)
            points.push_back(sobol_2d(i));
        expect_net(points, bits);
    }
}

TEST(Sampler, OwenScrambleDecidesEachBitByTheBitsAboveIt) {
    // The upper k bits of the result depend on nothing but the upper k bits of x, and the map is a
    // permutation.
    for (const std::uint32_t seed : kSeeds) {
        for (int k = 1; k <= 12; ++k) {
            std::set<std::uint32_t> results;
            for (std::uint32_t prefix = 0; prefix < 1u << k; ++prefix) {
                const std::uint32_t x = prefix << (32 - k);
                const std::uint32_t expected = owen_scramble(x, seed) >> (32 - k);
                const std::uint32_t other =
                    owen_scramble(x | low_bits(hash(prefix), 32 - k), seed) >> (32 - k);
                ASSERT_EQ(other, expected)
                    << "seed " << seed << ", prefix " << prefix << " of " << k << " bits";
                results.insert(expected);
            }
            ASSERT_EQ(results.size(), std::size_t{1} << k);
        }
    }
}

TEST(Sampler, OwenScrambleFlipsBitsDifferentlyUnderDifferentPrefixes) {
    // A random digital shift would flip a bit the same way everywhere; a nested scramble must not.
    int flips = 0;
    constexpr int kPrefixes = 1024;
    for (std::uint32_t prefix = 0; prefix < kPrefixes; ++prefix) {
        const std::uint32_t x = prefix << 22;
        flips += static_cast<int>(((owen_scramble(x, 0x1234567u) ^ x) >> 21) & 1u);
    }
    // Binomial with p = 1/2: six standard deviations of 16 around 512.
    EXPECT_NEAR(flips, kPrefixes / 2, 6 * 16);
}

TEST(Sampler, SamplesAreNetsInEveryPairOfDimensions) {
    for (const std::uint32_t seed : kSeeds) {
        const std::uint32_t key = sampler_key({17, 5}, seed, 0);
        for (std::uint32_t pair = 0; pair < 4; ++pair) {
            // 2^12 at most: sample_2d keeps 24 bits of each coordinate.
            for (int bits = 0; bits <= 12; ++bits) {
                std::vector<glm::uvec2> points;
                for (std::uint32_t i = 0; i < 1u << bits; ++i) {
                    points.emplace_back(glm::uvec2(sample_2d(key, i, pair) * 0x1p24f) << 8u);
                }
                expect_net(points, bits);
            }
        }
    }
}

TEST(Sampler, EveryAlignedBlockOfSamplesIsANet) {
    const std::uint32_t key = sampler_key({3, 4}, 5, 1);
    for (std::uint32_t block = 0; block < 16; ++block) {
        std::vector<glm::uvec2> points;
        for (std::uint32_t i = 64 * block; i < 64 * (block + 1); ++i) {
            points.emplace_back(glm::uvec2(sample_2d(key, i, 2) * 0x1p24f) << 8u);
        }
        expect_net(points, 6);
    }
}

TEST(Sampler, SamplesStayBelowOne) {
    float largest = 0.0f;
    for (std::uint32_t i = 0; i < 1u << 20; ++i) {
        const glm::vec2 u = sample_2d(hash(i), i, i & 7u);
        ASSERT_GE(std::min(u.x, u.y), 0.0f);
        largest = std::max({largest, u.x, u.y});
    }
    EXPECT_LE(largest, 1.0f - 0x1p-24f);
    // 2^21 uniform numbers: that none is within 2^-16 of 1 has a chance of exp(-32).
    EXPECT_GT(largest, 1.0f - 0x1p-16f);
}

TEST(Sampler, KeysTellPixelsSeedsAndEstimatesApart) {
    std::set<std::uint32_t> keys;
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            for (std::uint32_t seed = 0; seed < 4; ++seed) {
                for (std::uint32_t estimate = 0; estimate < 2; ++estimate) {
                    keys.insert(sampler_key({x, y}, seed, estimate));
                }
            }
        }
    }
    // Among 2048 random 32-bit numbers the expected number of equal pairs is 0.0005.
    EXPECT_EQ(keys.size(), 16u * 16u * 4u * 2u);
}

TEST(Sampler, NeighbouringStreamsAreUncorrelated) {
    // Pearson's r of n independent pairs has a standard deviation of 1 / sqrt(n): 4.5 of them.
    constexpr std::uint32_t kStreams = 1u << 16;
    struct Pair {
        const char* what;
        std::uint32_t key_step;
        std::uint32_t dimension_step;
    };
    for (const Pair& pair : {Pair{"pixels", 1, 0}, Pair{"dimensions", 0, 1}}) {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < kStreams; ++i) {
            const auto a = sample_2d(sampler_key({i, 7}, 1, 0), 0, 0);
            const auto b = sample_2d(sampler_key({i + pair.key_step, 7}, 1, 0), 0, pair.dimension_step);
            sum += 12.0 * (static_cast<double>(a.x) - 0.5) * (static_cast<double>(b.x) - 0.5);
        }
        EXPECT_LT(std::abs(sum / kStreams), 4.5 / std::sqrt(static_cast<double>(kStreams))) << pair.what;
    }
}

}  // namespace
}  // namespace utsuri
