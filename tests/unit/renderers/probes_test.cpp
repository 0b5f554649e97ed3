// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/probes.h"

#include "renderers/reflection/reflectors/capture_point.h"
#include "renderers/reflection/reflectors/reflectors.h"
#include "support/scenes.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace utsuri {
namespace {

/// The reflector is instance 0 of every scene here.
constexpr std::uint32_t kReflector = 0;
constexpr double kMirrorZ = -0.95;

Material grey() {
    return test::lambert(glm::vec3(0.5f));
}

/// A mirror along a wall of a gallery six times as long as it is wide.
Scene gallery() {
    Scene scene;
    test::add(scene, test::quad({-6, 0.5f, -0.95f}, {12, 0, 0}, {0, 1.5f, 0}), test::mirror());
    test::add(scene, test::room({-6.5f, 0, -1}, {6.5f, 2.5f, 1}), grey());
    return scene;
}

/// A mirror with a screen before the half of it at x < 0.
Scene screened_mirror() {
    Scene scene;
    test::add(scene, test::quad({-1, 0.5f, -0.95f}, {2, 0, 0}, {0, 1.5f, 0}), test::mirror());
    test::add(scene, test::room({-2, 0, -1}, {2, 2.5f, 2}), grey());
    test::add(scene, test::quad({-1.5f, 0.2f, -0.5f}, {1.5f, 0, 0}, {0, 2, 0}), grey());
    return scene;
}

std::vector<glm::dvec3> points(const SceneData& data, MapKind kind, std::uint32_t most) {
    std::vector<glm::dvec3> result;
    for (const Probe& probe : place_probes(data, find_reflectors(data).instances, kind, {most, {}}))
        result.push_back(probe.capture_point);
    return result;
}

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
    glm::dvec3 hit;
};

/// Rays off a mirror in the plane z = kMirrorZ, of x within +-half_width: not those that placed the probes.
std::vector<Ray> rays_off_mirror(const SceneData& data, double half_width) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<Ray> rays;
    while (rays.size() < 4000) {
        const glm::dvec3 origin =
            glm::dvec3(half_width * (2.0 * share(random) - 1.0), 0.5 + 1.5 * share(random), kMirrorZ) -
            data.origin;
        const double radius = std::sqrt(share(random));
        const double angle = 2.0 * std::numbers::pi * share(random);
        const glm::dvec3 direction(radius * std::cos(angle), radius * std::sin(angle),
                                   std::sqrt(1.0 - radius * radius));
        const auto hit = closest_hit_reference(data.bvh, origin, direction, 1e3, [&](std::uint32_t triangle) {
            return data.triangle_infos[triangle].instance != kReflector;
        });
        if (hit) rays.push_back({origin, direction, origin + hit->t * direction});
    }
    return rays;
}

/// Mean angle by which a look-up along the ray misses what it meets, at the probe that it passes nearest.
double mean_parallax(const std::vector<Ray>& rays, const std::vector<glm::dvec3>& probes) {
    double sum = 0.0;
    for (const Ray& ray : rays) {
        const auto nearest =
            std::min_element(probes.begin(), probes.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
                return glm::length(glm::cross(a - ray.origin, ray.direction)) <
                       glm::length(glm::cross(b - ray.origin, ray.direction));
            });
        const glm::dvec3 towards = glm::normalize(ray.hit - *nearest);
        sum += std::acos(std::clamp(glm::dot(towards, ray.direction), -1.0, 1.0));
    }
    return sum / static_cast<double>(rays.size());
}

/// Share of what the rays meet that some probe sees.
double share_seen(const SceneData& data, const std::vector<Ray>& rays,
                  const std::vector<glm::dvec3>& probes) {
    const auto seen = std::count_if(rays.begin(), rays.end(), [&](const Ray& ray) {
        return std::any_of(probes.begin(), probes.end(), [&](const glm::dvec3& probe) {
            return !closest_hit_reference(data.bvh, probe, ray.hit - probe, 1.0 - 1e-6, [&](std::uint32_t t) {
                return data.triangle_infos[t].instance != kReflector;
            });
        });
    });
    return static_cast<double>(seen) / static_cast<double>(rays.size());
}

TEST(Probes, OneIsTheCapturePoint) {
    const SceneData data = prepare_scene_data(gallery());
    const auto found = points(data, MapKind::cube, 1);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], find_capture_point(data, kReflector));
}

TEST(Probes, AreNotAddedWhereNothingIsNear) {
    Scene scene;
    test::add(scene, test::icosphere({0, 1, 0}, 0.5f, 2), test::mirror());
    EXPECT_EQ(points(prepare_scene_data(scene), MapKind::cube, 8).size(), 1u) << "there is no parallax";
}

TEST(Probes, AreNotAddedWhereOneSeesEverything) {
    Scene scene;
    test::add(scene, test::quad({-1, 0.5f, -1.9f}, {2, 0, 0}, {0, 1, 0}), test::mirror());
    test::add(scene, test::room({-3, 0, -2}, {3, 2.5f, 2}), grey());
    const SceneData data = prepare_scene_data(scene);
    EXPECT_EQ(points(data, MapKind::distance, 8).size(), 1u) << "distances tell where in a room a ray ends";
    EXPECT_GT(points(data, MapKind::cube, 8).size(), 1u) << "directions alone do not";
}

TEST(Probes, LowerTheErrorOfOtherRaysToo) {
    const SceneData data = prepare_scene_data(gallery());
    const std::vector<Ray> rays = rays_off_mirror(data, 6.0);
    const auto four = points(data, MapKind::cube, 4);
    ASSERT_EQ(four.size(), 4u);
    for (const glm::dvec3& probe : four) {
        EXPECT_LE(std::abs(probe.x + data.origin.x), 6.0 + 1e-6);
        EXPECT_NEAR(probe.z + data.origin.z, kMirrorZ, 1e-6) << "on the mirror";
    }
    // Each of the three claims to take away 1/32; half of it is left for having been placed by 256 rays.
    const double first = mean_parallax(rays, {four[0]});
    EXPECT_LT(mean_parallax(rays, four), (1.0 - 3.0 / 64.0) * first);
}

TEST(Probes, WithDistancesSeeMore) {
    const SceneData data = prepare_scene_data(screened_mirror());
    const std::vector<Ray> rays = rays_off_mirror(data, 1.0);
    const auto probes = points(data, MapKind::distance, 4);
    ASSERT_GT(probes.size(), 1u);
    EXPECT_GT(share_seen(data, rays, probes), share_seen(data, rays, {probes[0]}));
}

TEST(Probes, ScaleWithTheScene) {
    for (const MapKind kind : {MapKind::cube, MapKind::hybrid}) {
        const auto original = points(prepare_scene_data(screened_mirror()), kind, 4);
        for (const int k : {-20, 20}) {
            const double factor = std::ldexp(1.0, k);
            const auto scaled = points(prepare_scene_data(test::scaled(screened_mirror(), factor)), kind, 4);
            ASSERT_EQ(scaled.size(), original.size());
            for (std::size_t i = 0; i < scaled.size(); ++i)
                EXPECT_EQ(scaled[i], factor * original[i]);
        }
    }
}

TEST(Probes, OfOneReflectorFollowOneAnother) {
    const std::vector<Probe> probes = {{0, {}}, {0, {}}, {1, {}}, {2, {}}, {2, {}}, {2, {}}};
    const auto ranges = probe_ranges(probes, 3);
    ASSERT_EQ(ranges.size(), 3u);
    EXPECT_EQ(ranges[0].first, 0u);
    EXPECT_EQ(ranges[0].count, 2u);
    EXPECT_EQ(ranges[1].first, 2u);
    EXPECT_EQ(ranges[1].count, 1u);
    EXPECT_EQ(ranges[2].first, 3u);
    EXPECT_EQ(ranges[2].count, 3u);
}

}  // namespace
}  // namespace utsuri
