// SPDX-License-Identifier: Apache-2.0
#include "geometry/convex_region.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace utsuri {
namespace {

/// [1, 2] x [3, 5] x [-8, -4].
std::vector<HalfSpace> box() {
    return {{{1, 0, 0}, 2},   {{-1, 0, 0}, -1}, {{0, 1, 0}, 5},
            {{0, -1, 0}, -3}, {{0, 0, 1}, -4},  {{0, 0, -1}, 8}};
}

TEST(ConvexRegion, IsSeenFromItsMiddle) {
    const auto region = enclosed_region(box());
    ASSERT_TRUE(region);
    EXPECT_LE(glm::distance(region->inside, glm::dvec3(1.5, 4, -6)), 1e-14);
    EXPECT_NEAR(region->about_inside.planes[5].distance, 2.0, 1e-14);
}

TEST(ConvexRegion, IsNoneWhereASideIsOpen) {
    for (std::size_t side = 0; side < 6; ++side) {
        std::vector<HalfSpace> planes = box();
        planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(side));
        EXPECT_FALSE(enclosed_region(planes)) << side;
    }
    // A frustum that narrows towards its open side is closed by its apex; one that widens is open.
    std::vector<HalfSpace> narrowing = box();
    narrowing.erase(narrowing.begin() + 2);
    std::vector<HalfSpace> widening = narrowing;
    const glm::dvec3 slant = glm::normalize(glm::dvec3(1, 1, 0));
    narrowing[0] = {slant, glm::dot(slant, glm::dvec3(2, 3, 0))};
    EXPECT_TRUE(enclosed_region(narrowing));
    widening[0] = {glm::normalize(glm::dvec3(1, -1, 0)), 0.0};
    EXPECT_FALSE(enclosed_region(widening));
}

TEST(ConvexRegion, IsNoneWhereNothingIsInside) {
    std::vector<HalfSpace> planes = box();
    planes[0].offset = 1.0;
    EXPECT_FALSE(enclosed_region(planes)) << "flat";
    planes[0].offset = 0.5;
    EXPECT_FALSE(enclosed_region(planes)) << "empty";
}

TEST(ConvexRegion, TellsBoxesFromOthers) {
    const auto bounds = box_of(box());
    ASSERT_TRUE(bounds);
    EXPECT_EQ(bounds->lower, glm::vec3(1, 3, -8));
    EXPECT_EQ(bounds->upper, glm::vec3(2, 5, -4));
    std::vector<HalfSpace> turned = box();
    turned[0].normal = glm::normalize(glm::dvec3(1, 1e-3, 0));
    EXPECT_FALSE(box_of(turned));
    std::vector<HalfSpace> twice = box();
    twice[0] = twice[2];
    EXPECT_FALSE(box_of(twice));
}

}  // namespace
}  // namespace utsuri
