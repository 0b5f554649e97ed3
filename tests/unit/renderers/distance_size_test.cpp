// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/distances/distance_maps.h"

#include <gtest/gtest.h>

#include <limits>

namespace utsuri {
namespace {

constexpr std::uint64_t kMiB = 1u << 20;

TEST(DistanceSize, IsThePowerOfTwoNextToThatOfMaps) {
    EXPECT_EQ(DistanceMaps::size_for(1), 1u);
    EXPECT_EQ(DistanceMaps::size_for(100), 128u);
    EXPECT_EQ(DistanceMaps::size_for(4096), kLargestDistanceMap);
}

// 1024 x 1024 texels of 12 bytes on 6 faces are 72 MiB a probe; bounds on radiance, a third more texels, 96
// MiB.
TEST(DistanceSize, IsHalvedUntilAllProbesFitIntoABuffer) {
    EXPECT_EQ(DistanceMaps::size_for(1024, 1, 128 * kMiB), 1024u);
    EXPECT_EQ(DistanceMaps::size_for(1024, 1, 95 * kMiB), 512u);
    EXPECT_EQ(DistanceMaps::size_for(1024, 3, 128 * kMiB), 512u);
    EXPECT_EQ(DistanceMaps::size_for(256, 3, 128 * kMiB), 256u);
    EXPECT_EQ(DistanceMaps::size_for(256, 1'000'000, 1), 1u);
    EXPECT_EQ(DistanceMaps::size_for(1024, 1'000, std::numeric_limits<std::uint64_t>::max()), 1024u);
}

}  // namespace
}  // namespace utsuri
