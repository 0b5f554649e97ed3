// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/reflectors.h"

#include "support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace utsuri {
namespace {

using testing::ElementsAre;

TEST(Reflectors, HaveASlotForEachOfTheirVerticesAndForNoOther) {
    Scene scene;
    test::add(scene, test::room(glm::vec3(-3.0f), glm::vec3(3.0f)), test::lambert(glm::vec3(0.5f)));
    test::add(scene, test::icosphere({1, 0, 0}, 0.5f, 1), test::mirror());
    test::add(scene, test::quad({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}), test::rough_metal(0.5f));
    test::add(scene, test::quad({-2, 0, 0}, {0, 1, 0}, {0, 0, 1}), test::mirror());
    const SceneData data = prepare_scene_data(scene);
    const Reflectors reflectors = find_reflectors(data);
    EXPECT_THAT(reflectors.instances, ElementsAre(1, 3));
    EXPECT_THAT(reflectors.instance_reflectors, ElementsAre(interop::NONE, 0, interop::NONE, 1));
    EXPECT_EQ(reflectors.vertices.size(), 42u + 4u);

    const WorldGeometry world = make_world_geometry(scene);
    std::size_t slots = 0;
    for (std::size_t vertex = 0; vertex < reflectors.vertex_slots.size(); ++vertex) {
        const std::uint32_t slot = reflectors.vertex_slots[vertex];
        if (slot == interop::NONE) continue;
        ++slots;
        EXPECT_EQ(reflectors.vertices.at(slot).position, world.positions[vertex]);
        EXPECT_EQ(reflectors.vertices.at(slot).normal, world.normals[vertex]);
    }
    EXPECT_EQ(slots, 46u);
}

TEST(Reflectors, AreNoneInAMatteScene) {
    Scene scene;
    test::add(scene, test::room(glm::vec3(-3.0f), glm::vec3(3.0f)), test::lambert(glm::vec3(0.5f)));
    const Reflectors reflectors = find_reflectors(prepare_scene_data(scene));
    EXPECT_TRUE(reflectors.instances.empty());
    EXPECT_TRUE(reflectors.vertices.empty());
    EXPECT_THAT(reflectors.instance_reflectors, ElementsAre(interop::NONE));
}

}  // namespace
}  // namespace utsuri
