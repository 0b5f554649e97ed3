// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/capture_point.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace utsuri {
namespace {

/// The reflector is instance 0 of every scene here.
constexpr std::uint32_t kReflector = 0;
/// The box of an icosphere is symmetric up to the rounding of its vertices.
constexpr double kCentre = 1e-6;

Material grey() {
    return test::lambert(glm::vec3(0.5f));
}

/// Scene space is world space moved by the scene's origin.
glm::dvec3 to_world(const SceneData& data, const glm::dvec3& point) {
    return point + data.origin;
}

TEST(CapturePoint, IsTheCentreOfAnObjectInARoom) {
    Scene scene;
    test::add(scene, test::icosphere({1.0f, 1.0f, -1.0f}, 0.3f, 2), test::mirror());
    test::add(scene, test::room({-3, 0, -2}, {3, 2.5f, 2}), grey());
    const SceneData data = prepare_scene_data(scene);
    const glm::dvec3 point = to_world(data, find_capture_point(data, kReflector));
    EXPECT_LT(glm::length(point - glm::dvec3(1.0, 1.0, -1.0)), kCentre);
}

TEST(CapturePoint, LiesOnAPlaneMirror) {
    Scene scene;
    test::add(scene, test::quad({-1, 0.5f, -1.9f}, {2, 0, 0}, {0, 1, 0}), test::mirror());
    test::add(scene, test::room({-3, 0, -2}, {3, 2.5f, 2}), grey());
    const SceneData data = prepare_scene_data(scene);
    const glm::dvec3 point = to_world(data, find_capture_point(data, kReflector));
    EXPECT_LT(glm::length(point - glm::dvec3(0.0, 1.0, -1.9)), kCentre);
}

TEST(CapturePoint, MovesOutOfGeometryThatAnExposedObjectEncloses) {
    // A mirror shell around an opaque ball: a map taken from the common centre would show the ball's inside.
    Scene scene;
    test::add(scene, test::icosphere({0, 0, 0}, 1.0f, 2), test::mirror());
    test::add(scene, test::icosphere({0, 0, 0}, 0.9f, 2), grey());
    test::add(scene, test::room(glm::vec3(-4.0f), glm::vec3(4.0f)), grey());
    const SceneData data = prepare_scene_data(scene);
    EXPECT_TRUE(is_inside_geometry(data, kReflector, glm::dvec3(0.0)));
    const glm::dvec3 point = find_capture_point(data, kReflector);
    EXPECT_FALSE(is_inside_geometry(data, kReflector, point));
    EXPECT_GT(glm::length(point), 0.85)
        << "outside of the ball, whose faces lie a little under 0.9 from its centre";
    EXPECT_LT(glm::length(point), 2.0) << "near the object";
}

TEST(CapturePoint, StaysInAnObjectThatIsBuriedItself) {
    // All of the object is inside closed geometry: there is no better place than its centre.
    Scene scene;
    test::add(scene, test::icosphere({0, 0, 0}, 0.5f, 1), test::mirror());
    test::add(scene, test::icosphere({0, 0, 0}, 2.0f, 2), grey());
    const SceneData data = prepare_scene_data(scene);
    EXPECT_LT(glm::length(find_capture_point(data, kReflector)), kCentre);
}

TEST(CapturePoint, OfAnObjectWithoutTrianglesIsTheOrigin) {
    Scene scene;
    test::add(scene, Mesh(), test::mirror());
    test::add(scene, test::room(glm::vec3(-1.0f), glm::vec3(1.0f)), grey());
    EXPECT_EQ(find_capture_point(prepare_scene_data(scene), kReflector), glm::dvec3(0.0));
}

TEST(CapturePoint, TellsInsideFromOutside) {
    Scene scene;
    test::add(scene, test::icosphere({10, 0, 0}, 0.1f, 0), test::mirror());
    test::add(scene, test::icosphere({0, 0, 0}, 1.0f, 2), grey());
    const SceneData data = prepare_scene_data(scene);
    EXPECT_TRUE(is_inside_geometry(data, kReflector, glm::dvec3(0.5, 0.2, 0.1) - data.origin));
    EXPECT_FALSE(is_inside_geometry(data, kReflector, glm::dvec3(1.5, 0.2, 0.1) - data.origin));
    EXPECT_FALSE(is_inside_geometry(data, kReflector, glm::dvec3(10.0, 0.0, 0.0) - data.origin))
        << "the object itself does not count";
}

}  // namespace
}  // namespace utsuri
