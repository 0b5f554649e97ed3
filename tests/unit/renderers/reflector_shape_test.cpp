// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/reflector_shape.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

/// The reflector is instance 0 of every scene here.
constexpr std::uint32_t kReflector = 0;

ReflectorShape shape_of(const Scene& scene, double factor = 1.0) {
    const SceneData data = prepare_scene_data(test::scaled(scene, factor));
    return describe_shape(data, kReflector);
}

Scene with_room(Mesh reflector) {
    Scene scene;
    test::add(scene, std::move(reflector), test::mirror());
    test::add(scene, test::room({-3, 0, -2}, {3, 2.5f, 2}), test::lambert(glm::vec3(0.5f)));
    return scene;
}

TEST(ReflectorShape, OfAPlaneMirrorFacesTheRoom) {
    // A hand's breadth in front of its wall; the quad's front points into the room in the first, at the wall
    // in the second.
    const Mesh towards = test::quad({-1, 0.5f, -1.9f}, {2, 0, 0}, {0, 1, 0});
    const Mesh away = test::quad({-1, 0.5f, -1.9f}, {0, 1, 0}, {2, 0, 0});
    for (const Mesh& mesh : {towards, away}) {
        for (const int k : {-20, 0, 20}) {
            const ReflectorShape shape = shape_of(with_room(mesh), std::ldexp(1.0, k));
            ASSERT_TRUE(shape.plane) << "k = " << k;
            EXPECT_TRUE(shape.convex);
            EXPECT_NEAR(shape.plane->normal.z, 1.0, 1e-12);
        }
    }
}

TEST(ReflectorShape, BentByMoreThanRoundingIsNoPlane) {
    Mesh bent = test::quad({-1, 0.5f, -1.0f}, {2, 0, 0}, {0, 1, 0});
    bent.positions[2].z += 1e-5f;
    const ReflectorShape shape = shape_of(with_room(bent));
    EXPECT_FALSE(shape.plane);
}

TEST(ReflectorShape, BallsAreConvexAndTwoBallsInOneAreNot) {
    const Mesh ball = test::icosphere({0.5f, 1.0f, 0.0f}, 0.3f, 3);
    EXPECT_TRUE(shape_of(with_room(ball)).convex);
    Mesh two = ball;
    const Mesh other = test::icosphere({-0.5f, 1.0f, 0.0f}, 0.3f, 3);
    const auto first = static_cast<std::uint32_t>(two.positions.size());
    two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
    two.normals.insert(two.normals.end(), other.normals.begin(), other.normals.end());
    for (const glm::uvec3& triangle : other.triangles)
        two.triangles.push_back(triangle + first);
    const ReflectorShape shape = shape_of(with_room(two));
    EXPECT_FALSE(shape.convex);
    EXPECT_FALSE(shape.plane);
}

TEST(ReflectorShape, SeenFromInsideIsNotConvex) {
    // The walls of a room are fronts inside: every vertex lies before every wall.
    const ReflectorShape shape = shape_of(with_room(test::room({-1, 0.5f, -1}, {1, 2, 1})));
    EXPECT_FALSE(shape.convex);
}

}  // namespace
}  // namespace utsuri
