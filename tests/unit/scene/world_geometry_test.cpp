// SPDX-License-Identifier: Apache-2.0
#include "scene/world_geometry.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace utsuri {
namespace {

/// Angle between a float32 normal and the truth: a few roundings.
constexpr double kFloat32 = 4.0 * 0x1p-23;

Scene sphere_with(const glm::dmat4& matrix) {
    Scene scene;
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 2), test::mirror());
    scene.instances[0].world_from_object = matrix;
    return scene;
}

glm::dvec3 face_normal(const WorldGeometry& world, const glm::uvec3& triangle) {
    const glm::dvec3 a(world.positions[triangle.x]);
    return glm::normalize(
        glm::cross(glm::dvec3(world.positions[triangle.y]) - a, glm::dvec3(world.positions[triangle.z]) - a));
}

TEST(WorldGeometry, PutsTheOriginInTheCentre) {
    Scene scene;
    test::add(scene, test::room({2.0f, -1.0f, 0.0f}, {6.0f, 3.0f, 8.0f}), test::lambert(glm::vec3(0.5f)));
    const WorldGeometry world = make_world_geometry(scene);
    EXPECT_EQ(world.origin, glm::dvec3(4.0, 1.0, 4.0));
    EXPECT_EQ(world.bounds.lower, glm::vec3(-2.0f, -2.0f, -4.0f));
    EXPECT_EQ(world.bounds.upper, glm::vec3(2.0f, 2.0f, 4.0f));
    EXPECT_EQ(world.triangles.size(), 12u);
    EXPECT_EQ(world.normals.size(), world.positions.size());
    EXPECT_EQ(world.texcoords.size(), world.positions.size());
}

TEST(WorldGeometry, DoesNotDependOnWhereTheSceneIs) {
    // All coordinates are multiples of 2^-10 and the offset is an integer, so float64 holds every sum
    // exactly.
    Scene scene;
    test::add(scene, test::room({-1.25f, -0.5f, -3.0f}, {2.0f, 1.5f, 0.0625f}),
              test::lambert(glm::vec3(0.5f)));
    const WorldGeometry here = make_world_geometry(scene);
    const glm::dvec3 offset(1e6, -123456789.0, 77.0);
    scene.instances[0].world_from_object = glm::translate(glm::dmat4(1.0), offset);
    const WorldGeometry there = make_world_geometry(scene);
    EXPECT_EQ(there.origin, here.origin + offset);
    EXPECT_EQ(there.positions, here.positions);
    EXPECT_EQ(there.normals, here.normals);
}

TEST(WorldGeometry, KeepsSharedVerticesShared) {
    const glm::dmat4 matrix =
        glm::rotate(glm::scale(glm::dmat4(1.0), {0.1, 7.0, 3.3}), 1.234, glm::normalize(glm::dvec3(1, 2, 3)));
    const Scene scene = sphere_with(matrix);
    const WorldGeometry world = make_world_geometry(scene);
    EXPECT_EQ(world.triangles, scene.meshes[0].triangles);
    EXPECT_EQ(world.positions.size(), scene.meshes[0].positions.size());
}

TEST(WorldGeometry, KeepsFrontsInFrontUnderMirroringMaps) {
    for (const glm::dvec3 scale :
         {glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(-2, -1, 1), glm::dvec3(-1, -3, -0.5)}) {
        const WorldGeometry world = make_world_geometry(sphere_with(glm::scale(glm::dmat4(1.0), scale)));
        for (const glm::uvec3& triangle : world.triangles) {
            const glm::dvec3 face = face_normal(world, triangle);
            EXPECT_GT(glm::dot(face, glm::dvec3(world.positions[triangle.x])), 0.0) << "fronts look outwards";
            for (int k = 0; k < 3; ++k)
                EXPECT_GT(glm::dot(face, glm::dvec3(world.normals[triangle[k]])), 0.0);
        }
    }
}

TEST(WorldGeometry, KeepsNormalsPerpendicularUnderUnevenScales) {
    // A plane stays a plane: its normals must follow it, whatever the scale along the axes.
    Scene scene;
    test::add(scene, test::quad({0, 0, 0}, {1, 0.5f, 0.25f}, {-0.5f, 1, 2}), test::mirror());
    scene.instances[0].world_from_object = glm::scale(glm::dmat4(1.0), {100.0, 0.01, -3.0});
    const WorldGeometry world = make_world_geometry(scene);
    for (const glm::uvec3& triangle : world.triangles) {
        const glm::dvec3 face = face_normal(world, triangle);
        for (int k = 0; k < 3; ++k) {
            EXPECT_LT(glm::length(glm::cross(face, glm::dvec3(world.normals[triangle[k]]))),
                      100.0 * kFloat32);
        }
    }
}

TEST(WorldGeometry, KeepsNormalsUnitAndFiniteUnderSingularMaps) {
    for (const glm::dvec3 scale : {glm::dvec3(1, 0, 1), glm::dvec3(0, 0, 1), glm::dvec3(0.0)}) {
        const WorldGeometry world = make_world_geometry(sphere_with(glm::scale(glm::dmat4(1.0), scale)));
        for (const glm::vec3& normal : world.normals) {
            EXPECT_NEAR(glm::length(glm::dvec3(normal)), 1.0, kFloat32);
        }
    }
}

TEST(WorldGeometry, TellsWhoseTriangleIsWhose) {
    Scene scene;
    test::add(scene, test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), test::mirror());
    test::add(scene, test::icosphere({0, 0, 3}, 0.5f, 0), test::mirror());
    const WorldGeometry world = make_world_geometry(scene);
    ASSERT_EQ(world.instances.size(), 22u);
    EXPECT_EQ(world.instances[1], 0u);
    EXPECT_EQ(world.instances[2], 1u);
    EXPECT_EQ(world.texcoords[2], glm::vec2(1.0f, 0.0f));
    EXPECT_EQ(world.texcoords[4], glm::vec2(0.0f)) << "a mesh without texture coordinates";
}

TEST(WorldGeometry, OfNothingIsEmpty) {
    const WorldGeometry world = make_world_geometry(Scene());
    EXPECT_TRUE(world.bounds.empty());
    EXPECT_EQ(world.origin, glm::dvec3(0.0));
    EXPECT_TRUE(world.triangles.empty());
}

}  // namespace
}  // namespace utsuri
