// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/plane_mirrors.h"

#include "support/light_scenes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace utsuri {
namespace {

using test::add;
using test::lambert;
using test::mirror;
using test::quad;

/// A square of n by n cells in z = 0, its middle line raised by `bend`, with the normals of a flat one.
Mesh grid(int n, float bend) {
    Mesh mesh;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) {
            const float share = static_cast<float>(x) / static_cast<float>(n);
            mesh.positions.emplace_back(share, static_cast<float>(y) / static_cast<float>(n),
                                        bend * (1.0f - std::abs(2.0f * share - 1.0f)));
            mesh.normals.emplace_back(0, 0, 1);
        }
    }
    const auto stride = static_cast<std::uint32_t>(n) + 1;
    for (std::uint32_t y = 0; y + 1 < stride; ++y) {
        for (std::uint32_t x = 0; x + 1 < stride; ++x) {
            const std::uint32_t i = y * stride + x;
            mesh.triangles.emplace_back(i, i + 1, i + stride + 1);
            mesh.triangles.emplace_back(i, i + stride + 1, i + stride);
        }
    }
    return mesh;
}

PlaneMirrors mirrors_of(const Scene& scene) {
    return find_plane_mirrors(prepare_scene_data(scene));
}

/// Sizes of the mirrors, in triangles.
std::vector<std::size_t> sizes(const PlaneMirrors& found) {
    std::vector<std::size_t> result;
    for (const PlaneMirror& mirror : found.mirrors)
        result.push_back(mirror.triangles.size());
    return result;
}

TEST(PlaneMirrors, AreFoundAmongBallsAndWalls) {
    Scene scene;
    add(scene, test::room(glm::vec3(-3.0f), glm::vec3(3.0f)), lambert(glm::vec3(0.5f)));
    add(scene, quad({-1, 0.5f, -2}, {2, 0, 0}, {0, 1.5f, 0}), mirror());
    add(scene, test::icosphere({1, 0, 0}, 0.5f, 2), mirror());
    const SceneData data = prepare_scene_data(scene);
    const PlaneMirrors found = find_plane_mirrors(data);
    ASSERT_EQ(sizes(found), std::vector<std::size_t>{2});
    EXPECT_EQ(found.others.size(), 320u);
    const PlaneMirror& plane = found.mirrors.front();
    EXPECT_EQ(plane.normal, glm::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(plane.offset, -2.0 - data.origin.z);
    for (const std::uint32_t triangle : plane.triangles)
        EXPECT_EQ(data.triangle_infos[triangle].instance, 1u);
    // The outline is the mirror itself.
    EXPECT_NEAR(
        glm::distance(plane.outline[0], plane.outline[1]) * glm::distance(plane.outline[1], plane.outline[2]),
        3.0, 1e-6);
}

TEST(PlaneMirrors, OfFloatingPointAreFoundHoweverTheyAreTurnedAndMeshed) {
    for (const int n : {1, 7, 40}) {
        for (int turn = 0; turn < 8; ++turn) {
            Scene scene;
            add(scene, test::room(glm::vec3(-5.0f), glm::vec3(5.0f)), lambert(glm::vec3(0.5f)));
            const std::uint32_t index = add(scene, grid(n, 0.0f), mirror());
            glm::dmat4& place = scene.instances[index].world_from_object;
            place = glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, -1.7, 2.1));
            place = glm::rotate(place, 0.7 * turn, glm::normalize(glm::dvec3(1, 2 + turn, -0.5)));
            place = glm::scale(place, glm::dvec3(2.3, 0.6, turn % 2 == 0 ? 1.0 : -1.0));
            const PlaneMirrors found = mirrors_of(scene);
            EXPECT_EQ(sizes(found), std::vector<std::size_t>{2u * static_cast<unsigned>(n * n)})
                << n << ' ' << turn;
            EXPECT_TRUE(found.others.empty());
        }
    }
}

TEST(PlaneMirrors, ReachAcrossInstancesAndFaceEitherSide) {
    Scene scene;
    add(scene, quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), mirror());
    add(scene, quad({5, 2, 1}, {0, 1, 0}, {1, 0, 0}), mirror());  // its front is behind
    add(scene, quad({0, 0, 3}, {1, 0, 0}, {0, 1, 0}), mirror());
    const PlaneMirrors found = mirrors_of(scene);
    EXPECT_THAT(sizes(found), testing::ElementsAre(4, 2));
}

// A tenth of a milliradian between two halves turns reflections by a fifth: a pixel of a close look.
TEST(PlaneMirrors, BentMeshesAreTwo) {
    Scene scene;
    add(scene, test::faceted(grid(2, 0.5e-4f)), mirror());
    EXPECT_THAT(sizes(mirrors_of(scene)), testing::ElementsAre(4, 4));
    // With the normals of a flat mesh it is neither flat nor two.
    Scene smooth;
    add(smooth, grid(2, 0.5e-4f), mirror());
    EXPECT_TRUE(mirrors_of(smooth).mirrors.empty());
}

TEST(PlaneMirrors, CurvedMeshesAreNone) {
    // Flat, but with normals of a curved surface: it shows a curved reflection.
    Scene scene;
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.normals[2] = glm::normalize(glm::vec3(0.001f, 0, 1));
    add(scene, mesh, mirror());
    const PlaneMirrors found = mirrors_of(scene);
    EXPECT_TRUE(found.mirrors.empty());
    EXPECT_EQ(found.others.size(), 2u);
}

TEST(PlaneMirrors, AHairApartAreTwo) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), mirror());
    // The least that is more than the rounding of coordinates of 2 m, corner by corner: some ten units.
    add(scene, quad({0, 0, 1e-5f}, {4, 0, 0}, {0, 4, 0}), mirror());
    EXPECT_THAT(sizes(mirrors_of(scene)), testing::ElementsAre(2, 2));
}

TEST(PlaneMirrors, AreTheSameAtAnyScale) {
    Scene scene;
    add(scene, test::faceted(test::icosphere({0.3f, 0.1f, -0.7f}, 1.0f, 1)), mirror());
    add(scene, quad({-1, 0.5f, -2}, {2, 0, 0.3f}, {0, 1.5f, 0}), mirror());
    const PlaneMirrors found = mirrors_of(scene);
    EXPECT_EQ(found.mirrors.size(), kMostPlaneMirrors);
    EXPECT_EQ(found.others.size(), 81u - kMostPlaneMirrors);
    for (const int k : {-20, 20}) {
        const double factor = std::ldexp(1.0, k);
        const PlaneMirrors scaled = mirrors_of(test::scaled(scene, factor));
        ASSERT_EQ(scaled.mirrors.size(), found.mirrors.size());
        EXPECT_EQ(scaled.others, found.others);
        for (std::size_t i = 0; i < found.mirrors.size(); ++i) {
            EXPECT_EQ(scaled.mirrors[i].triangles, found.mirrors[i].triangles);
            EXPECT_EQ(scaled.mirrors[i].normal, found.mirrors[i].normal);
            EXPECT_EQ(scaled.mirrors[i].offset, factor * found.mirrors[i].offset);
            EXPECT_EQ(scaled.mirrors[i].tolerance, factor * found.mirrors[i].tolerance);
            EXPECT_EQ(scaled.mirrors[i].outline[2], factor * found.mirrors[i].outline[2]);
        }
    }
}

TEST(PlaneMirrors, DegenerateTrianglesJoinOrAreLeft) {
    Scene scene;
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.triangles.emplace_back(0, 1, 1);
    add(scene, mesh, mirror());
    Mesh needle = quad({0, 0, 2}, {1, 0, 0}, {0, 1, 0});
    needle.triangles = {{0, 0, 2}};
    add(scene, needle, mirror());
    const PlaneMirrors found = mirrors_of(scene);
    EXPECT_THAT(sizes(found), testing::ElementsAre(3));
    EXPECT_EQ(found.others.size(), 1u);
}

TEST(PlaneMirrors, AreNoneInAMatteScene) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), lambert(glm::vec3(0.5f)));
    const PlaneMirrors found = mirrors_of(scene);
    EXPECT_TRUE(found.mirrors.empty());
    EXPECT_TRUE(found.others.empty());
}

}  // namespace
}  // namespace utsuri
