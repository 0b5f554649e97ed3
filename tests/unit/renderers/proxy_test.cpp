// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/proxy.h"

#include "renderers/reflection/proxies/proxy_box.h"
#include "support/coded_walls.h"
#include "support/light_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kTurn = std::numbers::pi / 6.0;
/// Corners of walls metres long are rounded to float32, and planes follow from them.
constexpr double kPlaneError = 1e-5;

/// Whether a proxy in scene space has exactly the planes of a room in world space.
void expect_planes(const SceneData& data, const Proxy& proxy, const std::vector<HalfSpace>& room) {
    const std::vector<HalfSpace> expected = moved_to(data.origin, room);
    EXPECT_EQ(proxy.planes.size(), expected.size());
    for (const HalfSpace& plane : expected) {
        const bool found = std::any_of(proxy.planes.begin(), proxy.planes.end(), [&](const HalfSpace& other) {
            return glm::distance(other.normal, plane.normal) <= kPlaneError &&
                   std::abs(other.offset - plane.offset) <= kPlaneError;
        });
        EXPECT_TRUE(found) << plane.normal.x << ' ' << plane.normal.y << ' ' << plane.normal.z << ' '
                           << plane.offset;
    }
}

Proxy fit(const SceneData& data, std::uint32_t instance, const glm::dvec3& world_point) {
    return find_proxy(data, instance, world_point - data.origin, std::nullopt);
}

/// The last instance.
std::uint32_t ball_in(Scene& scene, const glm::vec3& centre) {
    return add(scene, icosphere(centre, 0.3f, 2), mirror());
}

TEST(Proxy, IsTheBoxOfAFurnishedRoomAlongTheAxes) {
    Scene scene;
    add(scene, room({-2, 0, -3}, {4, 2.5f, 3}), lambert(glm::vec3(0.5f)));
    add(scene, block({2, 0, -1}, {3.5f, 0.9f, 1.2f}), lambert(glm::vec3(0.5f)));
    const std::uint32_t ball = ball_in(scene, {0.4f, 1.1f, 0.2f});
    const SceneData data = prepare_scene_data(scene);
    const Proxy proxy = fit(data, ball, {0.4, 1.1, 0.2});
    EXPECT_TRUE(proxy.planes.empty());
    EXPECT_LE(glm::distance(glm::dvec3(proxy.box.lower) + data.origin, glm::dvec3(-2, 0, -3)), 1e-5);
    EXPECT_LE(glm::distance(glm::dvec3(proxy.box.upper) + data.origin, glm::dvec3(4, 2.5, 3)), 1e-5);
}

TEST(Proxy, IsATurnedRoomFurnishedOrNot) {
    for (const bool furnished : {false, true}) {
        Scene scene;
        const CodedWalls walls = turned_room({0, 0, 0}, {4, 3, 5}, kTurn);
        walls.add_to(scene);
        if (furnished) add(scene, block({2, 0, 0}, {2.7f, 0.7f, 1.2f}), lambert(glm::vec3(0.5f)));
        const glm::dvec3 centre = turned({2.1, 1.4, 2.6}, kTurn);
        const std::uint32_t ball = ball_in(scene, glm::vec3(centre));
        const SceneData data = prepare_scene_data(scene);
        expect_planes(data, fit(data, ball, centre), walls.planes());
    }
}

// Floor and ceiling go on beyond the walls, so that no side of the scene is one of the room.
TEST(Proxy, IsAHexagonalRoomWithinALargerScene) {
    Scene scene;
    const CodedWalls walls = hexagonal_room({1, 0, -0.5}, 3.0, 2.8, 0.2);
    walls.add_to(scene);
    add(scene, block({20, 0, 20}, {24, 9, 21}), lambert(glm::vec3(0.5f)));
    const std::uint32_t ball = ball_in(scene, {0.8f, 1.4f, 0.2f});
    const SceneData data = prepare_scene_data(scene);
    expect_planes(data, fit(data, ball, {0.8, 1.4, 0.2}), walls.planes());
}

// Under a roof of two slopes.
TEST(Proxy, IsAnAttic) {
    Scene scene;
    CodedWalls walls;
    walls.add_wall({0, 0, 0}, {0, 0, 5}, {4, 0, 0});
    walls.add_wall({0, 0, 0}, {2, 3, 0}, {0, 0, 5});
    walls.add_wall({2, 3, 0}, {2, -3, 0}, {0, 0, 5});
    walls.add_wall({0, 0, 0}, {4, 0, 0}, {0, 3, 0});
    walls.add_wall({4, 0, 5}, {-4, 0, 0}, {0, 3, 0});
    walls.add_to(scene);
    const std::uint32_t ball = ball_in(scene, {2.1f, 1.0f, 2.4f});
    const SceneData data = prepare_scene_data(scene);
    expect_planes(data, fit(data, ball, {2.1, 1.0, 2.4}), walls.planes());
}

// The capture point on a mirror that ends where other walls begin: rounding must not part them.
TEST(Proxy, HoldsAMirrorBetweenTurnedWalls) {
    Scene scene;
    const CodedWalls walls = turned_room({0, 0, 0}, {4, 3, 5}, kTurn);
    walls.add_to(scene, 1u << 4);
    const std::uint32_t wall = add(
        scene,
        quad(glm::vec3(turned({0, 0, 0}, kTurn)), glm::vec3(turned({4, 0, 0}, kTurn)), glm::vec3(0, 3, 0)),
        mirror());
    const SceneData data = prepare_scene_data(scene);
    const Proxy proxy = fit(data, wall, turned({2, 1.5, 0}, kTurn));
    std::vector<HalfSpace> seen = moved_to(data.origin, walls.planes());
    seen.erase(seen.begin() + 4);
    for (const HalfSpace& plane : seen) {
        EXPECT_TRUE(std::any_of(proxy.planes.begin(), proxy.planes.end(),
                                [&](const HalfSpace& other) {
                                    return glm::distance(other.normal, plane.normal) <= kPlaneError &&
                                           std::abs(other.offset - plane.offset) <= kPlaneError;
                                }))
            << plane.normal.x << ' ' << plane.normal.y << ' ' << plane.normal.z;
    }
    // Rays may end anywhere: there must be a plane in every direction.
    EXPECT_TRUE(enclosed_region(proxy.planes));
}

TEST(Proxy, IsTheSameBitsAtAnyScale) {
    Scene scene;
    hexagonal_room({1, 0, -0.5}, 3.0, 2.8, 0.2).add_to(scene);
    add(scene, block({0.5f, 0, 0.5f}, {1.2f, 0.7f, 1.2f}), lambert(glm::vec3(0.5f)));
    const std::uint32_t ball = ball_in(scene, {0.8f, 1.4f, 0.2f});
    const SceneData data = prepare_scene_data(scene);
    const Proxy proxy = fit(data, ball, {0.8, 1.4, 0.2});
    EXPECT_GE(proxy.planes.size(), 8u);
    for (const int k : {-20, 20}) {
        const double factor = std::ldexp(1.0, k);
        const SceneData other = prepare_scene_data(scaled(scene, factor));
        const Proxy same = fit(other, ball, factor * glm::dvec3(0.8, 1.4, 0.2));
        ASSERT_EQ(same.planes.size(), proxy.planes.size());
        for (std::size_t i = 0; i < proxy.planes.size(); ++i) {
            EXPECT_EQ(same.planes[i].normal, proxy.planes[i].normal);
            EXPECT_EQ(same.planes[i].offset, factor * proxy.planes[i].offset);
        }
    }
}

TEST(Proxy, GivenIsPlacedInTheScene) {
    Scene scene;
    const std::uint32_t ball = ball_in(scene, {7, 1, 0});
    const SceneData data = prepare_scene_data(scene);
    ASSERT_EQ(data.origin, glm::dvec3(7, 1, 0));
    const GivenProxy room{"room.txt", turned_room({6, 0, -1}, {9, 3, 5}, kTurn).planes()};
    const Proxy planes = find_proxy(data, ball, {0, 0, 0}, room);
    expect_planes(data, planes, room.planes);
    const GivenProxy straight{"box.txt", turned_room({6, 0, -1}, {9, 3, 5}, 0.0).planes()};
    const Proxy box = find_proxy(data, ball, {0, 0, 0}, straight);
    EXPECT_TRUE(box.planes.empty());
    EXPECT_EQ(box.box.lower, glm::vec3(-1, -1, -1));
    EXPECT_EQ(box.box.upper, glm::vec3(2, 2, 5));
}

TEST(Proxy, PlanesOfOneAreBehindThoseOfOthers) {
    std::vector<interop::ProxyPlane> planes(3);
    const interop::ProxyInfo info =
        add_proxy(planes, {{}, turned_room({0, 0, 0}, {1, 2, 3}, kTurn).planes()});
    EXPECT_EQ(info.first_plane, 3u);
    EXPECT_EQ(info.planes, 6u);
    ASSERT_EQ(planes.size(), 9u);
    EXPECT_EQ(planes[3].offset, 0.0f);
    EXPECT_EQ(add_proxy(planes, {}).planes, 0u);
}

// The fitted box is the room, whatever stands in it; rays to its corners and furniture do not sway it.
TEST(ProxyBox, FindsTheWallsOfAFurnishedRoom) {
    Scene scene;
    add(scene, room({-2, 0, -3}, {4, 2.5f, 3}), lambert(glm::vec3(0.5f)));
    add(scene, room({2, 0, -1}, {3.5f, 0.9f, 1.2f}), lambert(glm::vec3(0.5f)));
    add(scene, icosphere({0.4f, 1.1f, 0.2f}, 0.3f, 2), mirror());
    const SceneData data = prepare_scene_data(scene);
    const glm::dvec3 point = glm::dvec3(0.4, 1.1, 0.2) - data.origin;
    const Bounds box = fit_proxy_box(sample_surroundings(data, 2, point));
    const glm::dvec3 lower = glm::dvec3(box.lower) + data.origin;
    const glm::dvec3 upper = glm::dvec3(box.upper) + data.origin;
    EXPECT_LE(glm::distance(lower, glm::dvec3(-2, 0, -3)), 1e-5);
    EXPECT_LE(glm::distance(upper, glm::dvec3(4, 2.5, 3)), 1e-5);
}

// A ball that reaches through the only wall there is: what is behind that starts no ray.
TEST(ProxyBox, HoldsWhatIsSeenOfItsReflector) {
    Scene scene;
    add(scene, quad({-5, -5, -1}, {10, 0, 0}, {0, 10, 0}), lambert(glm::vec3(0.5f)));
    add(scene, icosphere({0, 0, 0}, 2.0f, 1), mirror());
    const SceneData data = prepare_scene_data(scene);
    const Bounds box = fit_proxy_box(sample_surroundings(data, 1, -data.origin));
    EXPECT_NEAR(static_cast<double>(box.lower.z) + data.origin.z, -1.0, 1e-6);
    EXPECT_GE(static_cast<double>(box.upper.x) + data.origin.x, 1.9);
    EXPECT_GE(static_cast<double>(box.upper.z) + data.origin.z, 1.9);
}

// A mirror through all four walls around it: the box is the room all the same.
TEST(ProxyBox, IsTheRoomOfAMirrorThatReachesOutOfIt) {
    for (const float reach : {0.5f, 40.0f}) {
        Scene scene;
        add(scene, room({0, 0, 0}, {4, 3, 5}), lambert(glm::vec3(0.5f)));
        add(scene, quad({-reach, -reach, 1}, {4 + 2 * reach, 0, 0}, {0, 3 + 2 * reach, 0}), mirror());
        const SceneData data = prepare_scene_data(scene);
        const Bounds box = fit_proxy_box(sample_surroundings(data, 1, glm::dvec3(2, 1.5, 1) - data.origin));
        // Float32 holds places tens of metres from the origin to some micrometres.
        EXPECT_LE(glm::distance(glm::dvec3(box.lower) + data.origin, glm::dvec3(0, 0, 0)), 3e-5) << reach;
        EXPECT_LE(glm::distance(glm::dvec3(box.upper) + data.origin, glm::dvec3(4, 3, 5)), 3e-5) << reach;
    }
}

TEST(ProxyBox, IsTheSceneWhereNothingSurrounds) {
    Scene scene;
    add(scene, icosphere({0, 0, 0}, 2.0f, 1), mirror());
    const SceneData data = prepare_scene_data(scene);
    const Bounds box = fit_proxy_box(sample_surroundings(data, 0, {0, 0, 0}));
    EXPECT_EQ(box.lower, data.bounds.lower);
    EXPECT_EQ(box.upper, data.bounds.upper);
}

}  // namespace
}  // namespace utsuri::test
