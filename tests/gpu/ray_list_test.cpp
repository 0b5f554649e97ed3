// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/ray_list.h"

#include "support/scenes.h"
#include "support/test_device.h"
#include "support/triangle_soup.h"

#include "base/sampler.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace utsuri {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class RayListOnDevice : public DeviceTest {
  protected:
    static std::vector<interop::HitInfo> trace(const SceneData& data, std::span<const interop::RayInfo> rays,
                                               RayQuery query = RayQuery::closest_hit) {
        const GpuScene scene(device(), data);
        RayList list(device(), scene, query);
        list.upload(rays);
        list.trace();
        return list.hits();
    }

    static SceneData data_of(const test::TriangleSoup& soup) {
        Scene scene;
        test::add(scene, test::to_mesh(soup), test::lambert(glm::vec3(0.5f)));
        return prepare_scene_data(scene);
    }
};

/// Rays from anywhere to anywhere within the cube of the random soups.
std::vector<interop::RayInfo> random_rays(std::uint32_t count) {
    std::vector<interop::RayInfo> rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 origin = 2.0f * glm::vec3(sample_2d(31, i, 0), sample_2d(31, i, 1).x) - 1.0f;
        const glm::vec3 direction = 2.0f * glm::vec3(sample_2d(32, i, 0), sample_2d(32, i, 1).x) - 1.0f;
        rays.push_back({origin, direction, kInfinity, interop::NONE});
    }
    return rays;
}

int hit_count(const std::vector<interop::HitInfo>& hits) {
    return static_cast<int>(std::count_if(
        hits.begin(), hits.end(), [](const interop::HitInfo& hit) { return hit.triangle != interop::NONE; }));
}

TEST_F(RayListOnDevice, TellsDistanceAndBarycentricCoordinates) {
    test::TriangleSoup soup;
    soup.add({-1, -1, 0}, {3, -1, 0}, {-1, 3, 0});
    soup.add({-1, -1, -8}, {3, -1, -8}, {-1, 3, -8});
    const SceneData data = data_of(soup);
    const glm::vec3 shift(data.origin);
    // From z = 2 by steps of 4: the plane z = 0 is met at t = 1/2, at b1 = 1/4, b2 = 1/2.
    const std::vector<interop::RayInfo> rays = {
        {glm::vec3(0, 1, 2) - shift, {0, 0, -4}, kInfinity, interop::NONE},
        {glm::vec3(0, 1, -2) - shift, {0, 0, -4}, kInfinity, interop::NONE},
        {glm::vec3(0, 1, -9) - shift, {0, 0, -4}, kInfinity, interop::NONE}};
    const auto hits = trace(data, rays);
    EXPECT_EQ(hits[0].t, 0.5f);
    EXPECT_EQ(hits[0].b1, 0.25f);
    EXPECT_EQ(hits[0].b2, 0.5f);
    EXPECT_EQ(data.bvh.order[hits[0].triangle], 0u);
    EXPECT_EQ(hits[1].t, 1.5f);
    EXPECT_EQ(data.bvh.order[hits[1].triangle], 1u);
    EXPECT_EQ(hits[2].t, kInfinity);
    EXPECT_EQ(hits[2].triangle, interop::NONE);
}

TEST_F(RayListOnDevice, PassesThroughTheExcludedTriangle) {
    const SceneData data = data_of(test::random_soup(20000, 0.1f));
    std::vector<interop::RayInfo> rays = random_rays(20000);
    const auto first = trace(data, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
        rays[i].excluded = first[i].triangle;
    const auto second = trace(data, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (first[i].triangle == interop::NONE) {
            ASSERT_EQ(second[i].triangle, interop::NONE);
        } else {
            ASSERT_NE(second[i].triangle, first[i].triangle);
            ASSERT_GE(second[i].t, first[i].t) << "what comes next is not nearer";
        }
    }
    EXPECT_GT(hit_count(first), 10000);
    EXPECT_GT(hit_count(second), 10000);
}

TEST_F(RayListOnDevice, AnyHitTellsHitsWhereClosestHitDoes) {
    const SceneData data = data_of(test::random_soup(20000, 0.04f));
    std::vector<interop::RayInfo> rays = random_rays(50000);
    for (std::size_t i = 0; i < rays.size(); i += 2)
        rays[i].t_max = 0.25f;
    const auto closest = trace(data, rays);
    const auto any = trace(data, rays, RayQuery::any_hit);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(any[i].triangle == interop::NONE, closest[i].triangle == interop::NONE) << i;
        if (any[i].triangle != interop::NONE) {
            ASSERT_GE(any[i].t, closest[i].t) << i;
            ASSERT_LE(any[i].t, rays[i].t_max) << i;
        }
    }
    EXPECT_GT(hit_count(closest), 5000);
    EXPECT_LT(hit_count(closest), 45000);
}

TEST_F(RayListOnDevice, HonoursTheEndOfTheRay) {
    const SceneData data = data_of(test::random_soup(20000, 0.1f));
    std::vector<interop::RayInfo> rays = random_rays(20000);
    const auto free = trace(data, rays);
    std::vector<interop::RayInfo> up_to = rays;
    std::vector<interop::RayInfo> short_of = rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        up_to[i].t_max = free[i].t;
        short_of[i].t_max = std::nextafter(free[i].t, 0.0f);
    }
    const auto reached = trace(data, up_to);
    const auto missed = trace(data, short_of);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(reached[i].triangle, free[i].triangle) << i;
        ASSERT_EQ(reached[i].t, free[i].t) << i;
        ASSERT_EQ(missed[i].triangle, interop::NONE) << i;
    }
}

// A thousand copies of one triangle: whatever the order of the search, the last of the scene lies on top; and
// where nobody tells which one does, the first in device order is hit.
TEST_F(RayListOnDevice, BreaksTiesByLayersThenByTheLowestTriangle) {
    test::TriangleSoup soup;
    for (int i = 0; i < 1000; ++i)
        soup.add({-1, -1, 0}, {1, -1, 0}, {0, 1, 0.5f});
    std::vector<interop::RayInfo> rays;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const glm::vec3 origin(0.2f * sample_2d(33, i, 0) - 0.1f, (i & 1u) != 0 ? 3.0f : -3.0f);
        rays.push_back({origin, -origin, kInfinity, interop::NONE});
    }
    SceneData data = data_of(soup);
    for (const interop::HitInfo& hit : trace(data, rays))
        ASSERT_EQ(data.bvh.order[hit.triangle], 999u);
    data.layer_distance = 0.0f;
    for (const interop::HitInfo& hit : trace(data, rays))
        ASSERT_EQ(hit.triangle, 0u);
}

TEST_F(RayListOnDevice, ComesBackFromRaysThatAreNoRays) {
    const SceneData data = data_of(test::random_soup(20000, 0.1f));
    std::vector<interop::RayInfo> rays = random_rays(6400);
    const auto expected = trace(data, rays);
    const float nan = std::nanf("");
    const std::vector<glm::vec3> senseless = {
        {nan, nan, nan},    {nan, 1, 0},   {kInfinity, 0, 0}, {0, 0, 0}, {-kInfinity, kInfinity, 1},
        {1e38f, 1e-38f, 0}, {1e-45f, 0, 0}};
    // Among sound rays, which must not notice.
    for (std::size_t i = 0; i < rays.size(); i += 10) {
        rays[i].direction = senseless[i / 10 % senseless.size()];
        if (i % 20 == 0) rays[i].origin = senseless[i / 20 % senseless.size()];
    }
    for (const RayQuery query : {RayQuery::closest_hit, RayQuery::any_hit}) {
        const auto hits = trace(data, rays, query);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (i % 10 == 0) continue;
            ASSERT_EQ(hits[i].triangle == interop::NONE, expected[i].triangle == interop::NONE) << i;
            if (query == RayQuery::closest_hit) {
                ASSERT_EQ(hits[i].t, expected[i].t) << i;
            }
        }
    }
}

TEST_F(RayListOnDevice, DoesNotDependOnTheLengthOfTheDirection) {
    const SceneData data = data_of(test::random_soup(20000, 0.1f));
    std::vector<interop::RayInfo> rays = random_rays(20000);
    const auto expected = trace(data, rays);
    for (const int exponent : {-60, -20, 20, 60}) {
        std::vector<interop::RayInfo> scaled = rays;
        for (interop::RayInfo& ray : scaled)
            ray.direction *= std::ldexp(1.0f, exponent);
        const auto hits = trace(data, scaled);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(hits[i].triangle, expected[i].triangle) << exponent;
            ASSERT_EQ(hits[i].t, std::ldexp(expected[i].t, -exponent)) << exponent;
        }
    }
}

TEST_F(RayListOnDevice, FindsNothingInAnEmptyScene) {
    const SceneData data = prepare_scene_data(Scene());
    const auto hits = trace(data, random_rays(100));
    EXPECT_EQ(hit_count(hits), 0);
}

/// Rays at points of the segment from (-1, 0, 0) to (1, 0, 0) and at its middle.
std::vector<interop::RayInfo> rays_at_segment(std::uint32_t count) {
    std::vector<interop::RayInfo> rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 origin = 2.0f * glm::vec3(sample_2d(34, i, 0), sample_2d(34, i, 1).x) - 1.0f;
        const glm::vec3 target((i & 1u) != 0 ? 0.0f : 2.0f * sample_2d(35, i, 0).x - 1.0f, 0.0f, 0.0f);
        rays.push_back({origin, target - origin, kInfinity, interop::NONE});
    }
    return rays;
}

TEST_F(RayListOnDevice, NeverHitsTrianglesWithCoincidentVertices) {
    test::TriangleSoup soup;
    soup.add({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    soup.add({-1, 0, 0}, {1, 0, 0}, {1, 0, 0});
    soup.add({-1, 0, 0}, {-1, 0, 0}, {1, 0, 0});
    soup.add({-1, 0, 0}, {1, 0, 0}, {-1, 0, 0});
    EXPECT_EQ(hit_count(trace(data_of(soup), rays_at_segment(10000))), 0);
}

TEST_F(RayListOnDevice, HitsTrianglesOfCollinearVerticesOnlyWhereTheyAre) {
    // Rounding can make a sliver of three distinct points in a line; a hit of it is on the line all the same.
    test::TriangleSoup soup;
    soup.add({-1, 0, 0}, {0.125f, 0, 0}, {1, 0, 0});
    const std::vector<interop::RayInfo> rays = rays_at_segment(10000);
    const auto hits = trace(data_of(soup), rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].triangle == interop::NONE) continue;
        ASSERT_GE(std::min(hits[i].b1, hits[i].b2), 0.0f);
        // Three roundings of each coordinate.
        ASSERT_LE(hits[i].b1 + hits[i].b2, 1.0f + 3.0f * 0x1p-23f);
        ASSERT_TRUE(std::isfinite(hits[i].t));
    }
}

TEST_F(RayListOnDevice, TracesNoRays) {
    const SceneData data = data_of(test::random_soup(10, 0.5f));
    EXPECT_TRUE(trace(data, {}).empty());
}

}  // namespace
}  // namespace utsuri
