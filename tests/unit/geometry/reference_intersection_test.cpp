// SPDX-License-Identifier: Apache-2.0
#include "geometry/reference_intersection.h"

#include "support/triangle_soup.h"

#include "base/sampler.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Relative error allowed to float64 arithmetic of some twenty roundings without cancellation.
constexpr double kFloat64 = 1e-14;
/// Counter-clockwise seen from +z.
constexpr interop::BvhTriangle kUnitTriangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(ReferenceIntersection, FindsTheCrossingOfPlaneAndRay) {
    const auto hit =
        intersect_triangle_reference(kUnitTriangle, {0.25, 0.5, 3.0}, {0.0, 0.0, -2.0}, kInfinity);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 1.5, 1.5 * kFloat64);
    EXPECT_NEAR(hit->b1, 0.25, kFloat64);
    EXPECT_NEAR(hit->b2, 0.5, kFloat64);
    EXPECT_FALSE(hit->back_face);
}

TEST(ReferenceIntersection, TellsTheBackFromTheFront) {
    const auto hit =
        intersect_triangle_reference(kUnitTriangle, {0.25, 0.5, -3.0}, {0.0, 0.0, 1.0}, kInfinity);
    ASSERT_TRUE(hit);
    EXPECT_TRUE(hit->back_face);
    EXPECT_NEAR(hit->t, 3.0, 3.0 * kFloat64);
}

TEST(ReferenceIntersection, MissesWhatTheRayDoesNotCross) {
    const glm::dvec3 down(0.0, 0.0, -1.0);
    EXPECT_FALSE(intersect_triangle_reference(kUnitTriangle, {0.75, 0.5, 1.0}, down, kInfinity))
        << "beyond an edge";
    EXPECT_FALSE(intersect_triangle_reference(kUnitTriangle, {-1e-9, 0.5, 1.0}, down, kInfinity))
        << "just beside";
    EXPECT_FALSE(intersect_triangle_reference(kUnitTriangle, {0.25, 0.25, -1.0}, down, kInfinity))
        << "behind";
    EXPECT_FALSE(intersect_triangle_reference(kUnitTriangle, {-1.0, 0.25, 0.0}, {1.0, 0.0, 0.0}, kInfinity))
        << "in the plane";
    constexpr interop::BvhTriangle kFlat{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_FALSE(intersect_triangle_reference(kFlat, {1.0, 0.0, 1.0}, down, kInfinity)) << "without area";
}

TEST(ReferenceIntersection, HonoursAnOpenInterval) {
    const glm::dvec3 origin(0.25, 0.25, 1.0);
    const glm::dvec3 down(0.0, 0.0, -1.0);
    EXPECT_FALSE(intersect_triangle_reference(kUnitTriangle, origin, down, 1.0));
    EXPECT_TRUE(intersect_triangle_reference(kUnitTriangle, origin, down, 1.0 + 1e-9));
    EXPECT_FALSE(intersect_triangle_reference(kUnitTriangle, {0.25, 0.25, 0.0}, down, kInfinity)) << "t = 0";
}

/// Rays from anywhere in [-1.5, 1.5]^3 in any direction.
std::pair<glm::dvec3, glm::dvec3> random_ray(std::uint32_t i) {
    const glm::dvec2 a(sample_2d(77, i, 0));
    const glm::dvec2 b(sample_2d(77, i, 1));
    const glm::dvec2 c(sample_2d(77, i, 2));
    return {3.0 * glm::dvec3(a, b.x) - 1.5, 2.0 * glm::dvec3(b.y, c) - 1.0};
}

std::optional<ReferenceHit> closest_by_exhaustion(const Bvh& bvh, const glm::dvec3& origin,
                                                  const glm::dvec3& direction) {
    std::optional<ReferenceHit> best;
    for (std::uint32_t i = 0; i < bvh.triangles.size(); ++i) {
        auto hit =
            intersect_triangle_reference(bvh.triangles[i], origin, direction, best ? best->t : kInfinity);
        if (!hit) continue;
        hit->triangle = i;
        best = hit;
    }
    return best;
}

TEST(ReferenceIntersection, FindsWhatExhaustionFinds) {
    const test::TriangleSoup soup = test::random_soup(1000, 0.3f);
    const Bvh bvh = build_bvh(soup.positions, soup.triangles);
    int hits = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const auto [origin, direction] = random_ray(i);
        const auto expected = closest_by_exhaustion(bvh, origin, direction);
        const auto found = closest_hit_reference(bvh, origin, direction, kInfinity);
        ASSERT_EQ(found.has_value(), expected.has_value()) << i;
        if (!found) continue;
        ++hits;
        ASSERT_EQ(found->triangle, expected->triangle) << i;
        ASSERT_EQ(found->t, expected->t) << i;
    }
    EXPECT_GT(hits, 200) << "too few to tell";
}

TEST(ReferenceIntersection, PassesThroughWhatIsNotAccepted) {
    test::TriangleSoup soup;
    for (const float z : {3.0f, 2.0f, 1.0f, 0.0f})
        soup.add({-1, -1, z}, {2, -1, z}, {-1, 2, z});
    const Bvh bvh = build_bvh(soup.positions, soup.triangles);
    // The four layers are met at t = 1, 2, 3, 4.
    const auto hit =
        closest_hit_reference(bvh, {0, 0, 4}, {0, 0, -1}, kInfinity,
                              [&](std::uint32_t triangle) { return bvh.triangles[triangle].v0.z < 1.5f; });
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 3.0, 3.0 * kFloat64);
    EXPECT_EQ(bvh.triangles[hit->triangle].v0.z, 1.0f);
}

TEST(ReferenceIntersection, FindsNothingInAnEmptyTree) {
    const Bvh bvh = build_bvh({}, {});
    EXPECT_FALSE(closest_hit_reference(bvh, {0, 0, 0}, {0, 0, 1}, kInfinity));
}

}  // namespace
}  // namespace utsuri
