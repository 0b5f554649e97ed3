// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/reflector_plane.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

/// The reflector is instance 0 of every scene here.
constexpr std::uint32_t kReflector = 0;

std::optional<ReflectorPlane> plane_of_reflector(const Scene& scene, double factor = 1.0) {
    const SceneData data = prepare_scene_data(test::scaled(scene, factor));
    return plane_of(data, kReflector);
}

Scene with_room(Mesh reflector) {
    Scene scene;
    test::add(scene, std::move(reflector), test::mirror());
    test::add(scene, test::room({-3, 0, -2}, {3, 2.5f, 2}), test::lambert(glm::vec3(0.5f)));
    return scene;
}

TEST(ReflectorPlane, OfAPlaneMirrorFacesTheRoom) {
    // A hand's breadth in front of its wall; the quad's front points into the room in the first, at the wall
    // in the second.
    const Mesh towards = test::quad({-1, 0.5f, -1.9f}, {2, 0, 0}, {0, 1, 0});
    const Mesh away = test::quad({-1, 0.5f, -1.9f}, {0, 1, 0}, {2, 0, 0});
    for (const Mesh& mesh : {towards, away}) {
        for (const int k : {-20, 0, 20}) {
            const std::optional<ReflectorPlane> plane =
                plane_of_reflector(with_room(mesh), std::ldexp(1.0, k));
            ASSERT_TRUE(plane) << "k = " << k;
            EXPECT_NEAR(plane->normal.z, 1.0, 1e-12);
        }
    }
}

TEST(ReflectorPlane, BentByMoreThanRoundingIsNoPlane) {
    Mesh bent = test::quad({-1, 0.5f, -1.0f}, {2, 0, 0}, {0, 1, 0});
    bent.positions[2].z += 1e-5f;
    EXPECT_FALSE(plane_of_reflector(with_room(bent)));
}

TEST(ReflectorPlane, OfABallIsNone) {
    EXPECT_FALSE(plane_of_reflector(with_room(test::icosphere({0.5f, 1.0f, 0.0f}, 0.3f, 3))));
}

}  // namespace
}  // namespace utsuri
