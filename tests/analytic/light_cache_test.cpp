// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces, held against closed forms at the very points where it is kept.
#include "renderers/common/light_cache.h"

#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "base/error.h"

#include "interop/bindings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Scene, plan and contents of a cache.
struct Filled {
    SceneData data;
    std::vector<interop::LightCacheTriangle> plan;
    std::vector<interop::LightCachePoint> points;
    FrameCounts counts;
};

Filled fill(Device& device, const Scene& scene, const LightCacheSettings& settings) {
    Filled filled;
    filled.data = prepare_scene_data(scene);
    filled.plan = plan_light_cache(filled.data, settings.spacing, 1u << 20);
    const GpuScene gpu_scene(device, filled.data);
    LightCache cache(device, filled.data, settings);
    Progress progress;
    double seconds_to_compile = 0.0;
    filled.counts = cache.fill(gpu_scene, 3, seconds_to_compile, progress);
    EXPECT_EQ(cache.points(), light_cache_points(filled.plan));
    filled.points = cache.bindings()
                        .at(interop::BINDING_LIGHT_CACHE_POINTS)
                        ->download_records<interop::LightCachePoint>(cache.points());
    return filled;
}

/// Calls visit(triangle, position in world space, point) for every point, in the order in which
/// interop/light_cache.h numbers them.
template <typename Visit>
void for_each_point(const Filled& filled, Visit&& visit) {
    for (std::size_t t = 0; t < filled.plan.size(); ++t) {
        const std::uint32_t edge = filled.plan[t].edge;
        if (edge == 0) continue;
        const interop::BvhTriangle& corners = filled.data.bvh.triangles[t];
        std::size_t at = filled.plan[t].first_point;
        for (std::uint32_t j = 0; j <= edge; ++j) {
            for (std::uint32_t i = 0; i + j <= edge; ++i, ++at) {
                const double b1 = static_cast<double>(i) / edge;
                const double b2 = static_cast<double>(j) / edge;
                visit(t,
                      filled.data.origin + (1.0 - b1 - b2) * glm::dvec3(corners.v0) +
                          b1 * glm::dvec3(corners.v1) + b2 * glm::dvec3(corners.v2),
                      filled.points[at]);
            }
        }
    }
}

class LightCacheOnSurfaces : public DeviceTest {};

// One light, no chance: E cos / pi on the side it shines on, nothing on the other.
TEST_F(LightCacheOnSurfaces, SunOnAFloor) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0.6, -0.8, 0.0};
    sun.intensity = {3.0f, 2.0f, 1.0f};
    scene.lights.push_back(sun);
    const Filled filled = fill(device(), scene, {0.05, 4});
    int visited = 0;
    for_each_point(filled, [&](std::size_t, const glm::dvec3&, const interop::LightCachePoint& point) {
        ++visited;
        for (int c = 0; c < 3; ++c) {
            const double expected = static_cast<double>(sun.intensity[c]) * 0.8 / kPi;
            EXPECT_NEAR(static_cast<double>(point.front[c]), expected, kRounding * expected);
            EXPECT_EQ(point.back[c], 0.0f);
        }
    });
    EXPECT_GT(visited, 400);
    EXPECT_GE(filled.counts.rays, 4u * filled.points.size());
}

// Lambert's formula under a square of radiance 1, at every point on the floor: the mean of their differences
// from it is within its standard error of 0, and each is within many of its own.
TEST_F(LightCacheOnSurfaces, SquareOverAFloor) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const Filled filled = fill(device(), scene, {0.04, 256});
    const std::array<glm::dvec3, 4> square = {
        glm::dvec3{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}};
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;
    for_each_point(
        filled, [&](std::size_t, const glm::dvec3& position, const interop::LightCachePoint& point) {
            if (std::abs(position.y) > 1e-6) return;
            const double expected = std::abs(polygon_irradiance(square, position, {0, 1, 0})) / kPi;
            const double error = static_cast<double>(point.front.x) / expected - 1.0;
            // 256 samples of an integrand whose spread is below its mean.
            EXPECT_LE(std::abs(error), 6.0 / std::sqrt(256.0));
            sum += error;
            squares += error * error;
            ++count;
            EXPECT_EQ(point.back, glm::vec3(0.0f));
        });
    ASSERT_GT(count, 500);
    const double deviation = std::sqrt(squares / count / count);
    EXPECT_LE(std::abs(sum / count), kSigmas * deviation);
    EXPECT_LE(deviation, 2e-3) << "too noisy to tell";
}

// The floor of a closed box, whose walls meet it, gets nothing from a light outside.
TEST_F(LightCacheOnSurfaces, ClosedBoxStaysDark) {
    Scene scene;
    const std::uint32_t box = add(scene, room({-1, -1, -1}, {1, 1, 1}), lambert(glm::vec3(0.7f)));
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {0.3, 2.5, 0.2};
    lamp.intensity = glm::vec3(100.0f);
    scene.lights.push_back(lamp);
    const Filled filled = fill(device(), scene, {0.03, 1});
    bool lit_outside = false;
    for_each_point(filled, [&](std::size_t t, const glm::dvec3&, const interop::LightCachePoint& point) {
        ASSERT_EQ(filled.data.triangle_infos[t].instance, box);
        EXPECT_EQ(point.front, glm::vec3(0.0f));
        lit_outside = lit_outside || point.back.x > 0.0f;
    });
    EXPECT_TRUE(lit_outside);
}

TEST_F(LightCacheOnSurfaces, SameForAnySplitOfTheWork) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    // More samples than one dispatch takes, twice: how time cuts the points differs from run to run.
    const Filled first = fill(device(), scene, {0.1, 300});
    const Filled second = fill(device(), scene, {0.1, 300});
    ASSERT_EQ(first.points.size(), second.points.size());
    for (std::size_t i = 0; i < first.points.size(); ++i) {
        EXPECT_EQ(first.points[i].front, second.points[i].front);
        EXPECT_EQ(first.points[i].back, second.points[i].back);
    }
}

TEST(LightCachePlan, KeepsNeighboursWithinTheSpacing) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.5f)));
    add(scene, icosphere({0, 1, 0}, 0.5f, 2), lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    const double diagonal = glm::length(glm::dvec3(data.bounds.extent()));
    const auto plan = plan_light_cache(data, 0.01, 1u << 24);
    ASSERT_EQ(plan.size(), data.triangle_infos.size());
    std::uint64_t first = 0;
    for (std::size_t t = 0; t < plan.size(); ++t) {
        const interop::BvhTriangle& corners = data.bvh.triangles[t];
        const double longest = std::max({static_cast<double>(glm::distance(corners.v0, corners.v1)),
                                         static_cast<double>(glm::distance(corners.v1, corners.v2)),
                                         static_cast<double>(glm::distance(corners.v2, corners.v0))});
        EXPECT_LE(longest / plan[t].edge, 0.01 * diagonal * (1.0 + kRounding));
        EXPECT_TRUE(plan[t].edge == 1 || longest / (plan[t].edge - 1) > 0.01 * diagonal * (1.0 - kRounding));
        EXPECT_EQ(plan[t].first_point, first);
        first += (plan[t].edge + 1) * (plan[t].edge + 2) / 2;
    }
    EXPECT_EQ(light_cache_points(plan), first);
}

TEST(LightCachePlan, PassesOverWhatReflectsNothingDiffusely) {
    Scene scene;
    add(scene, ground(2.0f), mirror());
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const SceneData data = prepare_scene_data(scene);
    const auto plan = plan_light_cache(data, 0.01, 1u << 24);
    EXPECT_EQ(light_cache_points(plan), 0u);
}

TEST(LightCachePlan, GetsCoarserUntilItFits) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    const std::uint64_t wanted = light_cache_points(plan_light_cache(data, 1e-3, ~std::uint64_t{0}));
    for (const std::uint64_t most : {wanted / 3, wanted / 100, std::uint64_t{6}}) {
        const std::uint64_t points = light_cache_points(plan_light_cache(data, 1e-3, most));
        EXPECT_LE(points, most);
        // Half of what is allowed is used, unless triangles are too few for the choice.
        EXPECT_GE(points, most < 100 ? 6 : most / 2);
    }
}

}  // namespace
}  // namespace utsuri::test
