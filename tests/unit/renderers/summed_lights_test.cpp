// SPDX-License-Identifier: Apache-2.0
// Lights in groups: every light in one, which is about one lamp.
#include "renderers/light/direct/summed_lights.h"

#include "support/light_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace utsuri::test {
namespace {

struct Listed {
    SceneData data;
    SummedLights lights;
};

Listed list(const Scene& scene) {
    Listed listed{prepare_scene_data(scene), {}};
    listed.lights = list_summed_lights(listed.data, find_light_pieces(listed.data));
    return listed;
}

/// Groups of the lights that are triangles of an instance.
std::set<std::uint32_t> groups_of(const Listed& listed, std::uint32_t instance) {
    std::set<std::uint32_t> groups;
    for (const interop::SummedLight& light : listed.lights.lights) {
        const interop::LightInfo& info = listed.data.lights[light.light];
        if (info.type == interop::LIGHT_TRIANGLE &&
            listed.data.triangle_infos[info.triangle].instance == instance)
            groups.insert(light.group);
    }
    return groups;
}

void expect_all_in_groups(const Listed& listed) {
    std::set<std::uint32_t> lights;
    std::set<std::uint32_t> groups;
    for (const interop::SummedLight& light : listed.lights.lights) {
        lights.insert(light.light);
        groups.insert(light.group);
    }
    EXPECT_EQ(listed.lights.lights.size(), listed.data.lights.size());
    EXPECT_EQ(lights.size(), listed.data.lights.size());
    EXPECT_EQ(groups.size(), listed.lights.groups.size());
    EXPECT_EQ(*groups.rbegin() + 1, groups.size());
    EXPECT_LE(groups.size(), std::size_t{interop::MOST_LIGHT_GROUPS});
}

TEST(SummedLights, ALampIsAGroupWhateverItIsMadeOf) {
    Scene scene;
    add(scene, ground(4.0f), lambert(glm::vec3(0.5f)));
    const std::uint32_t bulb = add(scene, icosphere({-2, 1, 0}, 0.05f, 2), emitter(glm::vec3(50.0f)));
    const std::uint32_t panel = add(scene, ceiling({1, 2, 0}, 0.6f), emitter(glm::vec3(3.0f)));
    const std::uint32_t screen = add(scene, ceiling({-2, 2, 3}, 0.2f), emitter(glm::vec3(0.1f)));
    scene.environment = glm::vec3(0.1f);
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {3, 1, -3};
    scene.lights.push_back(lamp);
    const Listed listed = list(scene);
    expect_all_in_groups(listed);
    EXPECT_EQ(listed.lights.groups.size(), 5u);
    EXPECT_EQ(listed.lights.groups[0].reference, interop::LIGHT_CLUSTER_LEAF);
    // One ray tells whether the point light is in shadow.
    EXPECT_EQ(std::ranges::count(listed.lights.groups, 1u, &interop::LightGroup::most_samples), 1);
    std::set<std::uint32_t> different;
    for (const std::uint32_t instance : {bulb, panel, screen}) {
        ASSERT_EQ(groups_of(listed, instance).size(), 1u) << instance;
        different.merge(groups_of(listed, instance));
    }
    EXPECT_EQ(different.size(), 3u);
}

// Weak ones that are near each other share groups; the strong one among them has one of its own.
TEST(SummedLights, MoreLampsThanGroups) {
    Scene scene;
    add(scene, ground(8.0f), lambert(glm::vec3(0.5f)));
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 place(static_cast<float>(i % 10) - 4.5f, 2.0f, static_cast<float>(i / 10) - 3.0f);
        add(scene, ceiling(place, 0.02f), emitter(glm::vec3(0.1f)));
    }
    const std::uint32_t strong = add(scene, ceiling({0, 1, 0}, 0.1f), emitter(glm::vec3(1000.0f)));
    const Listed listed = list(scene);
    expect_all_in_groups(listed);
    EXPECT_EQ(listed.lights.groups.size(), std::size_t{interop::MOST_LIGHT_GROUPS});
    const std::set<std::uint32_t> groups = groups_of(listed, strong);
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(std::ranges::count(listed.lights.lights, *groups.begin(), &interop::SummedLight::group), 2);
}

TEST(SummedLights, TrianglesWithoutATextureComeFirst) {
    Scene scene;
    Texture texture;
    texture.width = texture.height = 1;
    texture.rgba = {128, 128, 128, 255};
    scene.textures.push_back(texture);
    Material textured = emitter(glm::vec3(2.0f));
    textured.emissive_texture.texture = 0;
    Mesh picture = ceiling({0, 1, 0}, 0.5f);
    picture.texcoords.assign(picture.positions.size(), glm::vec2(0.0f));
    add(scene, picture, textured);
    add(scene, ceiling({3, 1, 0}, 0.5f), emitter(glm::vec3(4.0f)));
    const Listed listed = list(scene);
    expect_all_in_groups(listed);
    ASSERT_EQ(listed.lights.plain_triangles, 2u);
    ASSERT_EQ(listed.lights.triangles, 4u);
    for (std::uint32_t i = 0; i < 4; ++i)
        EXPECT_EQ(listed.lights.lights[i].first_piece == interop::NONE, i < 2) << i;
}

TEST(SummedLights, NotWhereThereAreTooMany) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, icosphere({0, 2, 0}, 0.5f, 3), emitter(glm::vec3(1.0f)));
    EXPECT_TRUE(sums_lights(prepare_scene_data(scene)));
    add(scene, icosphere({0, 4, 0}, 0.5f, 4), emitter(glm::vec3(1.0f)));
    EXPECT_FALSE(sums_lights(prepare_scene_data(scene)));
    Scene suns;
    add(suns, ground(1.0f), lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    suns.lights.assign(interop::MOST_LIGHT_GROUPS, sun);
    EXPECT_FALSE(sums_lights(prepare_scene_data(suns)));
}

TEST(SummedLights, NoneIsFine) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    EXPECT_TRUE(list(scene).lights.lights.empty());
}

}  // namespace
}  // namespace utsuri::test
