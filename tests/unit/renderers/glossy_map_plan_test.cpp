// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/glossy/glossy_map_plan.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

namespace utsuri {
namespace {

TEST(GlossyMapPlan, ASceneWithoutGlossyLobesNeedsNothing) {
    Scene scene;
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 1), test::mirror());
    test::add(scene, test::room(glm::vec3(-2.0f), glm::vec3(2.0f)), test::lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    const GlossyMapPlan plan = plan_glossy_maps(data, 256, {});
    EXPECT_TRUE(plan.levels.empty());
    EXPECT_EQ(plan.texels, 0u);
    EXPECT_EQ(glossy_map_bytes(data, 256), 0u);
}

TEST(GlossyMapPlan, OneRoughnessIsOneLevel) {
    Scene scene;
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 1), test::mirror());
    test::add(scene, test::icosphere(glm::vec3(3.0f), 1.0f, 1), test::glossy_metal(0.5f));
    const GlossyMapPlan plan =
        plan_glossy_maps(prepare_scene_data(scene), 256, {{0, glm::dvec3(3.0, 0.0, 0.0)}});
    ASSERT_EQ(plan.infos.size(), 2u);
    EXPECT_EQ(plan.infos[0].levels, 0u);
    EXPECT_EQ(plan.infos[1].levels, 1u);
    EXPECT_EQ(plan.infos[1].least_roughness, 0.5f);
    ASSERT_EQ(plan.levels.size(), 1u);
    EXPECT_EQ(plan.levels[0].size, 16u) << "4 / alpha";
    EXPECT_EQ(plan.texels, 6u * 18u * 18u);
}

TEST(GlossyMapPlan, EachCapturePointHasItsLevels) {
    Scene scene;
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 1), test::mirror());
    test::add(scene, test::icosphere(glm::vec3(3.0f), 1.0f, 1), test::glossy_metal(0.5f));
    test::add(scene, test::icosphere(glm::vec3(6.0f), 1.0f, 1), test::glossy_metal(0.5f));
    const SceneData data = prepare_scene_data(scene);
    EXPECT_EQ(data.requirements.glossy_instances, (std::vector<std::uint32_t>{1, 2}));
    const std::vector<Probe> probes = {{0, glm::dvec3(3.0)},
                                       {0, glm::dvec3(3.0, 3.0, 7.0)},
                                       {0, glm::dvec3(3.0, 3.0, 5.0)},
                                       {1, glm::dvec3(6.0)}};
    const GlossyMapPlan plan = plan_glossy_maps(data, 256, probes);
    EXPECT_EQ(plan.infos[1].first_probe, 0u);
    EXPECT_EQ(plan.infos[1].probes, 3u);
    EXPECT_EQ(plan.infos[1].blend_width, 1.0f) << "half of what the nearest two are apart";
    EXPECT_EQ(plan.infos[2].first_probe, 3u);
    EXPECT_EQ(plan.infos[2].probes, 1u);
    EXPECT_EQ(plan.most_probes(), 3u);
    ASSERT_EQ(plan.probes.size(), 4u);
    ASSERT_EQ(plan.levels.size(), 4u);
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(plan.probes[i].capture_point, glm::vec3(probes[i].capture_point));
        EXPECT_EQ(plan.probes[i].first_level, i);
        EXPECT_EQ(plan.levels[i].first_texel, i * 6 * 18 * 18);
    }
    EXPECT_EQ(plan.texels, 4u * 6u * 18u * 18u);
}

TEST(GlossyMapPlan, LevelsCoverTheRoughnessOfATexture) {
    Scene scene;
    Texture texture;
    texture.width = 2;
    texture.height = 1;
    texture.rgba = {0, 0, 255, 255, 0, 255, 255, 255};  // green: roughness 0 and 1
    scene.textures = {texture};
    Material material = test::glossy_metal(0.75f);
    material.metallic_roughness_texture.texture = 0;
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 1), material);
    const GlossyMapPlan plan = plan_glossy_maps(prepare_scene_data(scene), 64, {{0, glm::dvec3(0.0)}});
    const interop::GlossyMapInfo& info = plan.infos[0];
    EXPECT_EQ(info.levels, 7u);
    EXPECT_NEAR(info.least_roughness + static_cast<float>(info.levels - 1) / info.steps_per_unit, 0.75f,
                1e-6f);
    EXPECT_EQ(plan.levels.front().size, 64u) << "no finer than what is captured";
    for (std::size_t i = 1; i < plan.levels.size(); ++i)
        EXPECT_LE(plan.levels[i].size, plan.levels[i - 1].size);
}

}  // namespace
}  // namespace utsuri
