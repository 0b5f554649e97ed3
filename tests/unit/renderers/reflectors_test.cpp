// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/reflectors.h"

#include "support/scenes.h"

#include "base/error.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace utsuri {
namespace {

using testing::ElementsAre;

Scene two_mirrors_in_a_room() {
    Scene scene;
    test::add(scene, test::room(glm::vec3(-3.0f), glm::vec3(3.0f)), test::lambert(glm::vec3(0.5f)));
    test::add(scene, test::icosphere({1, 0, 0}, 0.5f, 1), test::mirror());
    test::add(scene, test::quad({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}), test::glossy_metal(0.5f));
    test::add(scene, test::quad({-2, 0, 0}, {0, 1, 0}, {0, 0, 1}), test::mirror());
    return scene;
}

TEST(Reflectors, HaveTheirPolygonsAndNoOther) {
    const Scene scene = two_mirrors_in_a_room();
    const SceneData data = prepare_scene_data(scene);
    const Reflectors reflectors = find_reflectors(data);
    EXPECT_THAT(reflectors.instances, ElementsAre(1, 3));
    EXPECT_THAT(reflectors.instance_reflectors, ElementsAre(interop::NONE, 0, interop::NONE, 1));
    EXPECT_EQ(reflectors.vertices.size(), 42u + 4u);
    EXPECT_EQ(reflectors.triangles.size(), 80u + 2u);
    for (const interop::ReflectorTriangle& triangle : reflectors.triangles) {
        const interop::TriangleInfo& info = data.triangle_infos[triangle.triangle];
        EXPECT_EQ(triangle.reflector, reflectors.instance_reflectors[info.instance]);
        const interop::BvhTriangle& corners = data.bvh.triangles[triangle.triangle];
        const glm::vec3 positions[3] = {corners.v0, corners.v1, corners.v2};
        for (int k = 0; k < 3; ++k) {
            const interop::ReflectorVertex& vertex = reflectors.vertices[triangle.vertices[k]];
            EXPECT_EQ(vertex.position, positions[k]);
            EXPECT_EQ(vertex.normal, data.normals[info.vertices[k]]);
            EXPECT_EQ(triangle.places[k], glm::vec2(k == 1, k == 2));
        }
    }
}

TEST(Reflectors, AreNoneInAMatteScene) {
    Scene scene;
    test::add(scene, test::room(glm::vec3(-3.0f), glm::vec3(3.0f)), test::lambert(glm::vec3(0.5f)));
    const Reflectors reflectors = find_reflectors(prepare_scene_data(scene));
    EXPECT_TRUE(reflectors.instances.empty());
    EXPECT_TRUE(reflectors.vertices.empty());
    EXPECT_THAT(reflectors.instance_reflectors, ElementsAre(interop::NONE));
}

double area_of(const Reflectors& reflectors) {
    double area = 0.0;
    for (const interop::ReflectorTriangle& triangle : reflectors.triangles) {
        const glm::dvec3 a(reflectors.vertices[triangle.vertices[0]].position);
        const glm::dvec3 b(reflectors.vertices[triangle.vertices[1]].position);
        const glm::dvec3 c(reflectors.vertices[triangle.vertices[2]].position);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// Calls visit(a, b) for both ends of every edge.
template <typename Visit>
void for_each_edge(const Reflectors& reflectors, Visit&& visit) {
    for (const interop::ReflectorTriangle& triangle : reflectors.triangles) {
        for (int k = 0; k < 3; ++k) {
            visit(reflectors.vertices[triangle.vertices[k]],
                  reflectors.vertices[triangle.vertices[(k + 1) % 3]]);
        }
    }
}

TEST(RefinedReflectors, HaveNoLongEdgeAndTheSameSurface) {
    const SceneData data = prepare_scene_data(two_mirrors_in_a_room());
    const Reflectors coarse = find_reflectors(data);
    Reflectors fine = coarse;
    refine(fine, {0.11, std::nullopt});
    EXPECT_GT(fine.triangles.size(), 10 * coarse.triangles.size());
    for_each_edge(fine, [](const interop::ReflectorVertex& a, const interop::ReflectorVertex& b) {
        EXPECT_LE(glm::distance(glm::dvec3(a.position), glm::dvec3(b.position)), 0.11);
    });
    // Some ten roundings of float32 positions.
    EXPECT_NEAR(area_of(fine), area_of(coarse), 1e-6 * area_of(coarse));
    // Corners lie where they say they lie on the triangle of the scene.
    for (const interop::ReflectorTriangle& triangle : fine.triangles) {
        const interop::BvhTriangle& parent = data.bvh.triangles[triangle.triangle];
        for (int k = 0; k < 3; ++k) {
            const glm::dvec2 b(triangle.places[k]);
            const glm::dvec3 place = (1.0 - b.x - b.y) * glm::dvec3(parent.v0) + b.x * glm::dvec3(parent.v1) +
                                     b.y * glm::dvec3(parent.v2);
            const glm::dvec3 position(fine.vertices[triangle.vertices[k]].position);
            EXPECT_LE(glm::distance(place, position), 1e-6);
        }
    }
}

// Every edge inside a closed surface still belongs to two polygons: no vertex lies on the middle of one.
TEST(RefinedReflectors, OpenNoGapBetweenNeighbours) {
    Scene scene;
    test::add(scene, test::icosphere({0, 0, 0}, 0.5f, 1), test::mirror());
    Reflectors reflectors = find_reflectors(prepare_scene_data(scene));
    refine(reflectors, {0.07, std::nullopt});
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> users;
    for (const interop::ReflectorTriangle& triangle : reflectors.triangles) {
        for (int k = 0; k < 3; ++k)
            ++users[std::minmax(triangle.vertices[k], triangle.vertices[(k + 1) % 3])];
    }
    for (const auto& [edge, count] : users)
        EXPECT_EQ(count, 2) << edge.first << ' ' << edge.second;
}

TEST(RefinedReflectors, InterpolateToTheErrorAskedFor) {
    Scene scene;
    test::add(scene, test::icosphere({0, 0, 0}, 0.5f, 1), test::mirror());
    Reflectors reflectors = find_reflectors(prepare_scene_data(scene));
    const double error = 0.2 * std::numbers::pi / 180.0;
    refine(reflectors, {std::nullopt, error});
    for_each_edge(reflectors, [&](const interop::ReflectorVertex& a, const interop::ReflectorVertex& b) {
        const double cosine = glm::dot(glm::dvec3(a.normal), glm::dvec3(b.normal));
        EXPECT_LE(interpolation_error(std::acos(std::min(1.0, cosine))), error * (1.0 + 1e-4));
    });
    // A flat mirror has nothing to gain.
    Scene flat;
    test::add(flat, test::quad({-2, 0, 0}, {0, 1, 0}, {0, 0, 1}), test::mirror());
    Reflectors plane = find_reflectors(prepare_scene_data(flat));
    refine(plane, {std::nullopt, error});
    EXPECT_EQ(plane.triangles.size(), 2u);
}

TEST(RefinedReflectors, RefuseWhatWouldNeverEnd) {
    Scene scene;
    test::add(scene, test::quad({-2, 0, 0}, {0, 1, 0}, {0, 0, 1}), test::mirror());
    Reflectors reflectors = find_reflectors(prepare_scene_data(scene));
    EXPECT_THROW(refine(reflectors, {1e-6, std::nullopt}), UsageError);
}

// Neighbouring unit vectors 5, 10, 20 and 30 degrees apart, in degrees.
TEST(InterpolationError, IsTheWorkedOne) {
    const double degree = std::numbers::pi / 180.0;
    const std::array<std::array<double, 2>, 4> worked = {
        {{5, 0.1092}, {10, 0.4386}, {20, 1.7817}, {30, 4.1172}}};
    for (const auto& [turn, error] : worked)
        EXPECT_NEAR(interpolation_error(turn * degree) / degree, error, 5e-5);
    EXPECT_EQ(interpolation_error(0.0), 0.0);
}

}  // namespace
}  // namespace utsuri
