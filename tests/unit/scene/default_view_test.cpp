// SPDX-License-Identifier: Apache-2.0
#include "scene/default_view.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

/// Rounding allowance of the float64 arithmetic at coordinates up to 1e6.
constexpr double kFloat64 = 1e-9;

Scene boxes(const glm::dvec3& offset) {
    Scene scene;
    test::add(scene, test::room({-3.0f, 0.0f, -2.0f}, {3.0f, 2.5f, 2.0f}), test::lambert(glm::vec3(0.5f)));
    test::add(scene, test::icosphere({1.0f, 1.0f, 0.0f}, 0.4f, 1), test::mirror());
    for (Instance& instance : scene.instances) {
        instance.world_from_object = glm::translate(glm::dmat4(1.0), offset);
    }
    return scene;
}

void expect_all_visible(const Scene& scene, const Camera& camera) {
    const double edge = std::tan(0.5 * camera.vertical_fov);
    for (const Instance& instance : scene.instances) {
        for (const glm::vec3& position : scene.meshes[instance.mesh].positions) {
            const glm::dvec3 world(instance.world_from_object * glm::dvec4(glm::dvec3(position), 1.0));
            const glm::dvec3 v = world - camera.position;
            const double depth = glm::dot(v, camera.forward);
            ASSERT_GT(depth, 0.0);
            EXPECT_LE(std::abs(glm::dot(v, camera.right)), depth * edge * (1.0 + kFloat64));
            EXPECT_LE(std::abs(glm::dot(v, camera.up)), depth * edge * (1.0 + kFloat64));
        }
    }
}

TEST(DefaultView, SeesTheWholeScene) {
    for (const glm::dvec3 offset : {glm::dvec3(0.0), glm::dvec3(1e6, -1e6, 5e5)}) {
        const Scene scene = boxes(offset);
        expect_all_visible(scene, frame_scene(scene));
    }
}

TEST(DefaultView, HasOrthonormalRightHandedAxes) {
    const Camera camera = frame_scene(boxes(glm::dvec3(0.0)));
    EXPECT_NEAR(glm::length(camera.forward), 1.0, kFloat64);
    EXPECT_NEAR(glm::length(glm::cross(camera.right, camera.up) + camera.forward), 0.0, kFloat64);
    EXPECT_NEAR(camera.right.y, 0.0, kFloat64) << "the horizon is level";
    EXPECT_GT(camera.up.y, 0.0);
}

TEST(DefaultView, ScalesWithTheScene) {
    const Scene scene = boxes(glm::dvec3(0.0));
    const Camera camera = frame_scene(scene);
    const Camera scaled = frame_scene(test::scaled(scene, 1024.0));
    EXPECT_EQ(scaled.position, 1024.0 * camera.position);
    EXPECT_EQ(scaled.forward, camera.forward);
}

TEST(DefaultView, IsDefinedForScenesWithoutSize) {
    const Camera empty = frame_scene(Scene());
    EXPECT_EQ(empty.position, glm::dvec3(0.0));
    EXPECT_EQ(empty.forward, glm::dvec3(0.0, 0.0, -1.0));

    Scene point;
    Mesh mesh;
    mesh.positions = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    mesh.normals.assign(3, {0, 1, 0});
    mesh.triangles = {{0, 1, 2}};
    test::add(point, mesh, test::lambert(glm::vec3(0.5f)));
    const Camera camera = frame_scene(point);
    EXPECT_NEAR(glm::length(camera.position - glm::dvec3(1, 2, 3)), 1.0, kFloat64);
}

}  // namespace
}  // namespace utsuri
