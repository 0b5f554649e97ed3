// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_data.h"

#include "renderers/device_scene/texture_table.h"
#include "support/scenes.h"

#include "geometry/bvh_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace utsuri {
namespace {

constexpr double kPi = std::numbers::pi;
/// Relative error of a probability: a float32, from lengths that are float32.
constexpr double kFloat32 = 4.0 * 0x1p-24;

/// A quad of one square metre in the plane z = `z`, seen from +z.
Mesh square(float z) {
    return test::quad({0, 0, z}, {1, 0, 0}, {0, 1, 0});
}

Light light_of(LightType type, float intensity) {
    Light light;
    light.type = type;
    light.intensity = glm::vec3(intensity);
    return light;
}

/// The power of a light over that of all.
double share_of_power(const SceneData& data, std::uint32_t light) {
    const interop::LightInfo& info = data.lights[light];
    const auto chosen = static_cast<double>(info.probability);
    if (light < data.infinite_lights()) return chosen;
    double power = 1.0;
    std::uint32_t child = 0;
    for (std::uint32_t level = 0; level < info.path_length; ++level) {
        const interop::LightTreeNode& node = data.light_tree[child & interop::LIGHT_CLUSTER_INDEX];
        const interop::LightCluster& cluster = (info.path >> level & 1u) == 0 ? node.first : node.second;
        power = static_cast<double>(cluster.power);
        child = cluster.child;
    }
    return chosen * power;
}

TEST(SceneData, ListsLightsByTheirPower) {
    Scene scene;
    test::add(scene, square(0.0f), test::lambert(glm::vec3(0.5f)));
    test::add(scene, square(2.0f), test::emitter(glm::vec3(3.0f)));
    scene.environment = glm::vec3(0.5f);
    Light spot = light_of(LightType::spot, 7.0f);
    spot.outer_cone_angle = 0.5;
    scene.lights = {light_of(LightType::point, 2.0f), spot, light_of(LightType::directional, 11.0f)};
    const SceneData data = prepare_scene_data(scene);

    const double radius_squared = 0.25 * (1.0 + 1.0 + 4.0);
    // The environment and directional ones first.
    const std::vector<double> powers = {kPi * kPi * radius_squared * 0.5,
                                        kPi * radius_squared * 11.0,
                                        4.0 * kPi * 2.0,
                                        2.0 * kPi * (1.0 - std::cos(0.5)) * 7.0,
                                        kPi * 0.5 * 3.0,
                                        kPi * 0.5 * 3.0};
    double sum = 0.0;
    for (const double power : powers)
        sum += power;
    ASSERT_EQ(data.lights.size(), powers.size());
    EXPECT_EQ(data.environment_light(), 0u);
    EXPECT_EQ(data.infinite_lights(), 2u);
    for (std::uint32_t i = 0; i < powers.size(); ++i)
        EXPECT_NEAR(share_of_power(data, i), powers[i] / sum, kFloat32) << i;
}

TEST(SceneData, LinksTriangleLightsBothWays) {
    Scene scene;
    test::add(scene, test::room(glm::vec3(-1.0f), glm::vec3(1.0f)), test::lambert(glm::vec3(0.5f)));
    test::add(scene, test::icosphere(glm::vec3(0.0f), 0.1f, 1), test::emitter(glm::vec3(1.0f)));
    const SceneData data = prepare_scene_data(scene);
    EXPECT_EQ(data.lights.size(), 80u);
    std::uint32_t linked = 0;
    for (std::uint32_t i = 0; i < data.triangle_infos.size(); ++i) {
        const interop::TriangleInfo& info = data.triangle_infos[i];
        EXPECT_EQ(info.light != interop::NONE, info.instance == 1);
        if (info.light == interop::NONE) continue;
        EXPECT_EQ(data.lights[info.light].triangle, i);
        ++linked;
    }
    EXPECT_EQ(linked, 80u);
}

TEST(SceneData, WeighsBothSidesOfADoubleSidedEmitter) {
    Scene scene;
    test::add(scene, square(0.0f), test::emitter(glm::vec3(1.0f)));
    test::add(scene, square(1.0f), test::emitter(glm::vec3(1.0f)));
    scene.materials[1].double_sided = true;
    const SceneData data = prepare_scene_data(scene);
    for (std::uint32_t i = 0; i < data.lights.size(); ++i) {
        const bool both = data.triangle_infos[data.lights[i].triangle].instance == 1;
        EXPECT_NEAR(share_of_power(data, i), both ? 1.0 / 3.0 : 1.0 / 6.0, kFloat32);
    }
}

TEST(SceneData, LeavesOutLightsThatCannotShine) {
    Scene scene;
    Mesh sliver = square(0.0f);
    sliver.positions[2] = sliver.positions[1];
    sliver.positions[3] = sliver.positions[0];  // no area left
    test::add(scene, sliver, test::emitter(glm::vec3(1.0f)));
    scene.lights = {light_of(LightType::point, 0.0f)};
    const SceneData data = prepare_scene_data(scene);
    EXPECT_TRUE(data.lights.empty());
    for (const interop::TriangleInfo& info : data.triangle_infos)
        EXPECT_EQ(info.light, interop::NONE);
}

TEST(SceneData, TurnsMaterialsIntoReflectances) {
    Scene scene;
    Material material;
    material.base_colour = {0.1f, 0.2f, 0.3f};
    material.metallic = 0.25f;
    material.roughness = 0.5f;
    material.specular = 0.5f;
    material.ior = 1.5f;
    test::add(scene, square(0.0f), material);
    const interop::MaterialInfo info = prepare_scene_data(scene).materials.at(0);
    EXPECT_EQ(info.base_colour, material.base_colour);
    EXPECT_EQ(info.metallic, 0.25f);
    EXPECT_EQ(info.roughness, 0.5f);
    // ((1.5 - 1) / (1.5 + 1))^2 = 0.04, scaled by the specular factor.
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(info.dielectric_f0[c]), 0.04, 0.04 * kFloat32);
    EXPECT_EQ(info.specular, 0.5f);
    EXPECT_EQ(info.base_colour_texture.texture, interop::NONE);
}

TEST(SceneData, PacksOnlyTexturesThatAreReferredTo) {
    Scene scene;
    scene.textures.resize(3);
    for (std::size_t i = 0; i < 3; ++i) {
        scene.textures[i].width = 2;
        scene.textures[i].height = 1;
        const auto base = static_cast<std::uint8_t>(16 * (i + 1));
        for (std::uint8_t k = 0; k < 8; ++k)
            scene.textures[i].rgba.push_back(static_cast<std::uint8_t>(base + k));
    }
    Material material = test::lambert(glm::vec3(1.0f));
    material.base_colour_texture = {2, TextureWrap::mirrored_repeat, TextureWrap::clamp_to_edge,
                                    TextureFilter::nearest};
    material.emissive_texture = {0, TextureWrap::repeat, TextureWrap::repeat, TextureFilter::linear};
    test::add(scene, square(0.0f), material);
    const SceneData data = prepare_scene_data(scene);
    ASSERT_EQ(data.texture_headers.size(), 2u);
    ASSERT_EQ(data.texels.size(), 4u);
    const interop::MaterialInfo& info = data.materials[0];
    const interop::TextureSlotInfo& base_colour = info.base_colour_texture;
    EXPECT_EQ(base_colour.width, 2u);
    EXPECT_EQ(data.texels[base_colour.first_texel], 0x33323130u) << "red in the lowest byte";
    EXPECT_EQ(info.base_colour_texture.sampling, 2u | (1u << 2) | (0u << 4));
    EXPECT_EQ(info.emissive_texture.sampling, 1u << 4);
    EXPECT_EQ(data.texels[info.emissive_texture.first_texel + 1], 0x17161514u);
}

TEST(SceneData, TakesMeansOfTexturesOverTheirColours) {
    EXPECT_EQ(mean_colour({"", 2, 1, {255, 0, 0, 7, 0, 255, 255, 9}}), 0.5);
    EXPECT_EQ(mean_colour({"", 1, 1, {128, 128, 128, 255}}), std::pow(128.0 / 255.0, 2.2));
}

TEST(SceneData, KeepsAttributesWithTheirTriangles) {
    Scene scene;
    test::add(scene, test::icosphere({1, 2, 3}, 0.5f, 2), test::mirror());
    test::add(scene, test::room({-2, -1, -3}, {2, 3, 4}), test::lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    EXPECT_EQ(check_bvh(data.bvh, 332), "");
    const WorldGeometry world = make_world_geometry(scene);
    ASSERT_EQ(data.triangle_infos.size(), 332u);
    for (std::size_t i = 0; i < data.triangle_infos.size(); ++i) {
        const interop::TriangleInfo& info = data.triangle_infos[i];
        EXPECT_EQ(data.bvh.triangles[i].v0, world.positions[info.vertices.x]);
        EXPECT_EQ(data.bvh.triangles[i].v2, world.positions[info.vertices.z]);
        EXPECT_EQ(info.instance, world.instances[data.bvh.order[i]]);
        EXPECT_EQ(info.material, info.instance);
    }
    EXPECT_TRUE(data.texcoords.empty()) << "a scene without textures needs none";
}

TEST(SceneData, PredictsItsSizeOnTheDevice) {
    Scene scene;
    test::add(scene, square(0.0f), test::emitter(glm::vec3(1.0f)));
    const SceneData data = prepare_scene_data(scene);
    const std::uint64_t expected =
        sizeof(interop::BvhNode) +
        2 * (sizeof(interop::BvhTriangle) + sizeof(interop::TriangleInfo) + sizeof(interop::LightInfo)) +
        4 * sizeof(glm::vec3) + sizeof(interop::MaterialInfo) + sizeof(interop::LightTreeNode);
    EXPECT_EQ(data.device_bytes(), expected);
}

}  // namespace
}  // namespace utsuri
