// SPDX-License-Identifier: Apache-2.0
// Where maps are captured: in the middle of the object, unless that is buried in another.
#include "renderers/reflection/reflectors/capture_point.h"

#include "support/light_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace utsuri::test {
namespace {

/// The capture point of the first instance, in world space.
glm::dvec3 capture_point(const Scene& scene) {
    const SceneData data = prepare_scene_data(scene);
    return find_capture_point(data, 0) + data.origin;
}

/// Two mirrors at x = -1 and x = 1, whose middle is the origin.
Scene pair_of_mirrors() {
    Scene scene;
    Mesh mesh = quad({1, -1, -1}, {0, 2, 0}, {0, 0, 2});
    const Mesh other = quad({-1, -1, -1}, {0, 0, 2}, {0, 2, 0});
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    for (const glm::uvec3& corners : other.triangles)
        mesh.triangles.push_back(corners + 4u);
    mesh.texcoords.clear();
    add(scene, mesh, mirror());
    return scene;
}

TEST(CapturePoint, IsTheMiddleOfAFreeObject) {
    Scene scene;
    add(scene, icosphere({3, 4, 5}, 0.5f, 2), mirror());
    add(scene, ground(10.0f), lambert(glm::vec3(0.5f)));
    EXPECT_LE(glm::length(capture_point(scene) - glm::dvec3(3, 4, 5)), 1e-5);
}

TEST(CapturePoint, StaysWhereOtherObjectsAreNear) {
    Scene scene = pair_of_mirrors();
    add(scene, block({0.2f, -0.1f, -0.1f}, {0.4f, 0.1f, 0.1f}), lambert(glm::vec3(0.5f)));
    EXPECT_LE(glm::length(capture_point(scene)), 1e-6);
}

TEST(CapturePoint, LeavesAnObjectThatItIsInside) {
    Scene scene = pair_of_mirrors();
    // The nearest way out of the block is up: 0.1, against 0.5 and more elsewhere.
    add(scene, block({-0.6f, -0.5f, -0.7f}, {0.6f, 0.1f, 0.7f}), lambert(glm::vec3(0.5f)));
    const glm::dvec3 point = capture_point(scene);
    EXPECT_GT(point.y, 0.1);
    const SceneData data = prepare_scene_data(scene);
    EXPECT_FALSE(is_inside_geometry(data, 0, point - data.origin));
    EXPECT_TRUE(is_inside_geometry(data, 0, -data.origin));
    // No farther out than half the object's radius, and not far aside: 64 directions leave a cone of some 15
    // degrees.
    EXPECT_LT(point.y, 0.1 + std::sqrt(3.0) / 2.0);
    EXPECT_LT(std::max(std::abs(point.x), std::abs(point.z)), point.y);
}

// A room whose walls show their backs to the inside must not drive the point out of it.
TEST(CapturePoint, StaysInARoomModelledInsideOut) {
    Scene scene;
    add(scene, icosphere({0.5f, 0, 0}, 0.5f, 2), mirror());
    add(scene, block(glm::vec3(-5.0f), glm::vec3(5.0f)), lambert(glm::vec3(0.5f)));
    EXPECT_LE(glm::length(capture_point(scene) - glm::dvec3(0.5, 0, 0)), 1e-6);
}

// An object wholly inside another is not exposed: nobody sees it from elsewhere, and its own middle is as
// good as any.
TEST(CapturePoint, StaysWithABuriedObject) {
    Scene scene;
    add(scene, icosphere(glm::vec3(0.0f), 0.2f, 2), mirror());
    add(scene, block(glm::vec3(-1.0f), glm::vec3(1.0f)), lambert(glm::vec3(0.5f)));
    EXPECT_LE(glm::length(capture_point(scene)), 1e-6);
}

}  // namespace
}  // namespace utsuri::test
