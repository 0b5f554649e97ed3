// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces, held against closed forms at the very points where it is kept.
#include "renderers/light/direct/light_cache.h"

#include "renderers/light/direct/lattice_plan.h"
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

Filled fill(Device& device, const Scene& scene, const LightSettings& settings) {
    Filled filled;
    filled.data = prepare_scene_data(scene);
    filled.plan = plan_light_cache(filled.data, settings.spacing, 1u << 20);
    const GpuScene gpu_scene(device, filled.data);
    LightCache cache(device, filled.data, gpu_scene, settings);
    Progress progress;
    cache.fill(progress);
    filled.counts = cache.cost().counts;
    filled.points = cache.points();
    EXPECT_EQ(filled.points.size(), light_cache_points(filled.plan));
    return filled;
}

/// Calls visit(triangle, position in world space, point) for every point, in the order in which
/// interop/light_cache.h numbers them.
template <typename Visit>
void for_each_point(const Filled& filled, Visit&& visit) {
    for (std::size_t t = 0; t < filled.plan.size(); ++t) {
        const interop::LightCacheTriangle& lattice = filled.plan[t];
        if (lattice.intervals == 0) continue;
        const interop::BvhTriangle& triangle = filled.data.bvh.triangles[t];
        const std::array<glm::dvec3, 3> corners = {glm::dvec3(triangle.v0), glm::dvec3(triangle.v1),
                                                   glm::dvec3(triangle.v2)};
        const glm::dvec3 apex = corners[lattice.apex];
        const glm::dvec3 from = corners[(lattice.apex + 1) % 3];
        const glm::dvec3 to = corners[(lattice.apex + 2) % 3];
        const std::uint32_t rows = lattice.intervals * lattice.rows_per_interval;
        std::size_t at = lattice.first_point;
        for (std::uint32_t j = 0; j <= rows; ++j) {
            const std::uint32_t intervals = lattice.intervals - j / lattice.rows_per_interval;
            for (std::uint32_t i = 0; i <= intervals; ++i, ++at) {
                const double along = intervals > 0 ? static_cast<double>(i) / intervals : 0.0;
                const glm::dvec3 on_base = glm::mix(from, to, along);
                visit(t, filled.data.origin + glm::mix(on_base, apex, static_cast<double>(j) / rows),
                      filled.points[at]);
            }
        }
        const std::size_t end =
            t + 1 < filled.plan.size() ? filled.plan[t + 1].first_point : filled.points.size();
        EXPECT_EQ(at, end);
    }
}

class LightCacheOnSurfaces : public DeviceTest {};

/// Counts dispatches: each is told of.
class CountingProgress : public Progress {
  public:
    void update(double /*done*/, double /*total*/) override { ++dispatches_; }
    [[nodiscard]] double dispatches() const { return dispatches_; }

  private:
    double dispatches_ = 0.0;
};

// A floor in the sun takes few rays, and its other side none: dispatches grow to what such points cost. They
// start at 64 points and grow eightfold until one takes 0.1 s; where a machine is slow, one that is not grown
// takes at least an eighth of that.
TEST_F(LightCacheOnSurfaces, PointsThatTakeFewRaysAreSimulatedTogether) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0, -1, 0};
    sun.intensity = glm::vec3(1.0f);
    scene.lights.push_back(sun);
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    LightCache cache(device(), data, gpu_scene, LightSettings());
    CountingProgress progress;
    cache.fill(progress);
    const auto points = static_cast<double>(cache.points().size());
    EXPECT_GT(points, 10000.0);
    const double growing = 1.0 + std::log(points / 64.0) / std::log(8.0);
    EXPECT_LE(progress.dispatches(), std::ceil(growing) + cache.cost().counts.gpu_seconds / (0.1 / 8.0));
}

// One light, no chance: E cos / pi on the side it shines on, nothing on the other.
TEST_F(LightCacheOnSurfaces, SunOnAFloor) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0.6, -0.8, 0.0};
    sun.intensity = {3.0f, 2.0f, 1.0f};
    scene.lights.push_back(sun);
    const Filled filled = fill(device(), scene, {0.05, 4, 3});
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
    EXPECT_GE(filled.counts.rays, filled.points.size());
}

/// Where the device's atan() is the least exact part: 4096 ulp are allowed, 1e-5 is what devices have.
constexpr double kTrigonometry = 1e-4;

/// Terms of up to 1 that cancel in Lambert's contour integral, over pi: some 30 roundings.
constexpr double kContour = 6e-7;

const std::array<glm::dvec3, 4> kSquare = {
    glm::dvec3{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}};

// Lambert's formula under a square of radiance 1, at every point on the floor: where nothing is in shadow
// there is no chance in it.
TEST_F(LightCacheOnSurfaces, SquareOverAFloor) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const Filled filled = fill(device(), scene, {0.04, 16, 3});
    int count = 0;
    for_each_point(
        filled, [&](std::size_t, const glm::dvec3& position, const interop::LightCachePoint& point) {
            if (std::abs(position.y) > 1e-6) return;
            const double expected = std::abs(polygon_irradiance(kSquare, position, {0, 1, 0})) / kPi;
            EXPECT_NEAR(static_cast<double>(point.front.x), expected, kTrigonometry * expected);
            EXPECT_EQ(point.back, glm::vec3(0.0f));
            ++count;
        });
    ASSERT_GT(count, 500);
}

// A wall through the plane of a square light sees the part of it that is above its horizon.
TEST_F(LightCacheOnSurfaces, SquareCutByTheHorizon) {
    Scene scene;
    add(scene, quad({0.2f, -1, 0.8f}, {0, 0.9f, 0}, {0, 0, -1.6f}), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const Filled filled = fill(device(), scene, {0.04, 16, 3});
    const std::array<glm::dvec3, 4> left = {
        glm::dvec3{-0.5, 1, -0.5}, {0.2, 1, -0.5}, {0.2, 1, 0.5}, {-0.5, 1, 0.5}};
    const std::array<glm::dvec3, 4> right = {
        glm::dvec3{0.2, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {0.2, 1, 0.5}};
    int count = 0;
    for_each_point(filled, [&](std::size_t t, const glm::dvec3& position,
                               const interop::LightCachePoint& point) {
        if (position.y > 0.0) return;
        const interop::BvhTriangle& triangle = filled.data.bvh.triangles[t];
        const bool front_is_left = glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0).x < 0.0f;
        const double lit_left = std::abs(polygon_irradiance(left, position, {-1, 0, 0})) / kPi;
        const double lit_right = std::abs(polygon_irradiance(right, position, {1, 0, 0})) / kPi;
        const double front = front_is_left ? lit_left : lit_right;
        const double back = front_is_left ? lit_right : lit_left;
        EXPECT_NEAR(static_cast<double>(point.front.x), front, kTrigonometry * front + kContour);
        EXPECT_NEAR(static_cast<double>(point.back.x), back, kTrigonometry * back + kContour);
        ++count;
    });
    ASSERT_GT(count, 200);
}

// A blocker half way up hides from every point what it covers as seen from there; in its penumbra samples
// tell what share that is. 256 of them are spread evenly over the light: the share is wrong by at most what
// its edge crosses of their strata, 2 of 16 columns.
TEST_F(LightCacheOnSurfaces, PenumbraOfABlocker) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    add(scene, quad({0, 0.5f, -3}, {3, 0, 0}, {0, 0, 6}), mirror());
    const Filled filled = fill(device(), scene, {0.04, 256, 3});
    int in_penumbra = 0;
    for_each_point(filled,
                   [&](std::size_t, const glm::dvec3& position, const interop::LightCachePoint& point) {
                       if (std::abs(position.y) > 1e-6) return;
                       // The blocker's edge x = 0, z any, at half the height is seen against x = -position.x.
                       const double edge = std::clamp(-position.x, -0.5, 0.5);
                       std::array<glm::dvec3, 4> seen = kSquare;
                       seen[1].x = seen[2].x = edge;
                       const double whole = std::abs(polygon_irradiance(kSquare, position, {0, 1, 0})) / kPi;
                       const double expected =
                           edge > -0.5 ? std::abs(polygon_irradiance(seen, position, {0, 1, 0})) / kPi : 0.0;
                       if (edge > -0.5 && edge < 0.5) ++in_penumbra;
                       EXPECT_NEAR(static_cast<double>(point.front.x), expected, 2.0 / 16.0 * whole)
                           << position.x << ' ' << position.z;
                   });
    EXPECT_GT(in_penumbra, 50);
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
    const Filled filled = fill(device(), scene, {0.03, 1, 3});
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
    const Filled first = fill(device(), scene, {0.1, 200, 3});
    // A dispatch of less than a workgroup, whose last one is not full.
    const Filled second = fill(device(), scene, {0.1, 200, 3, 7});
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
        const std::array<double, 3> opposite = {static_cast<double>(glm::distance(corners.v1, corners.v2)),
                                                static_cast<double>(glm::distance(corners.v2, corners.v0)),
                                                static_cast<double>(glm::distance(corners.v0, corners.v1))};
        const double base = opposite[plan[t].apex];
        const double longest = *std::max_element(opposite.begin(), opposite.end());
        EXPECT_EQ(base, *std::min_element(opposite.begin(), opposite.end()));
        const double spacing = 0.01 * diagonal * (1.0 + kRounding);
        EXPECT_LE(base / plan[t].intervals, spacing);
        EXPECT_LE(longest / (plan[t].intervals * plan[t].rows_per_interval), spacing);
        EXPECT_TRUE(plan[t].intervals == 1 || base / (plan[t].intervals - 1) * (1.0 + kRounding) > spacing);
        EXPECT_EQ(plan[t].first_point, first);
        const std::uint64_t n = plan[t].intervals;
        first += plan[t].rows_per_interval * (n * (n + 3) / 2) + 1;
    }
    EXPECT_EQ(light_cache_points(plan), first);
}

// A slat of 2 m by 1 cm is as fine along its length as along its width, not finer.
TEST(LightCachePlan, SpendsNothingOnTheWidthOfSlats) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {2, 0, 0}, {0, 0.01f, 0}), lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    const auto plan = plan_light_cache(data, 0.01, 1u << 24);
    ASSERT_EQ(plan.size(), 2u);
    for (const interop::LightCacheTriangle& triangle : plan) {
        EXPECT_EQ(triangle.intervals, 1u);
        EXPECT_NEAR(triangle.rows_per_interval, 100.0, 1.0);
    }
    EXPECT_LE(light_cache_points(plan), 410u);
}

// Its diagonal is 0, and so is the spacing.
TEST(LightCachePlan, HasOneIntervalForEachTriangleOfASceneThatIsOnePoint) {
    Mesh mesh;
    mesh.positions.assign(3, glm::vec3(1, 2, 3));
    mesh.normals.assign(3, glm::vec3(0, 0, 1));
    mesh.triangles = {{0, 1, 2}};
    Scene scene;
    add(scene, mesh, lambert(glm::vec3(0.5f)));
    for (const std::uint64_t most : {std::uint64_t{1}, std::uint64_t{1} << 24}) {
        const auto plan = plan_light_cache(prepare_scene_data(scene), 0.01, most);
        ASSERT_EQ(plan.size(), 1u);
        EXPECT_EQ(plan[0].intervals, 1u);
        EXPECT_EQ(plan[0].rows_per_interval, 1u);
        EXPECT_EQ(light_cache_points(plan), 3u);
    }
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
        // A third of what is allowed is used, unless triangles are too few for the choice.
        EXPECT_GE(points, most < 100 ? 6 : most / 3);
    }
}

}  // namespace
}  // namespace utsuri::test
