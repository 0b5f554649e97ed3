// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/place_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace utsuri {
namespace {

// A grid of 4 x 4 places on each of two triangles, shuffled: triangle by triangle, and quarter by quarter.
TEST(PlaceOrder, NeighboursFollowEachOther) {
    std::vector<interop::LightMeshPlace> places;
    for (std::uint32_t i = 0; i < 32; ++i)
        places.push_back({i / 16, (static_cast<float>(i % 4) + 0.5f) / 4.0f,
                          (static_cast<float>(i / 4 % 4) + 0.5f) / 4.0f, 0, 0, 0});
    std::shuffle(places.begin(), places.end(), std::mt19937(5));
    const std::vector<std::uint32_t> order = order_by_place(places);
    ASSERT_EQ(order.size(), places.size());
    for (std::uint32_t i = 0; i < 32; ++i) {
        const interop::LightMeshPlace& place = places[order[i]];
        EXPECT_EQ(place.triangle, i / 16);
        const std::uint32_t quarter = i / 4 % 4;
        EXPECT_EQ(place.b1 >= 0.5f, (quarter & 1u) != 0) << i;
        EXPECT_EQ(place.b2 >= 0.5f, (quarter & 2u) != 0) << i;
    }
}

TEST(PlaceOrder, KeepsPlacesThatAreTheSameInTheirOrder) {
    const std::vector<interop::LightMeshPlace> places(5, interop::LightMeshPlace{1, 1.0f, 0.0f, 0, 0, 0});
    EXPECT_EQ(order_by_place(places), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(order_by_place({}).empty());
}

}  // namespace
}  // namespace utsuri
