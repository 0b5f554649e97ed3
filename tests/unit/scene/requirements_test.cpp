// SPDX-License-Identifier: Apache-2.0
#include "scene/requirements.h"

#include "support/scenes.h"

#include "interop/shading.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace utsuri {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Mesh unit_quad() {
    return test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
}

/// A texture of one row of texels, RGBA.
Texture texture(std::initializer_list<std::array<std::uint8_t, 4>> texels) {
    Texture result;
    result.width = static_cast<std::uint32_t>(texels.size());
    result.height = 1;
    for (const auto& texel : texels)
        result.rgba.insert(result.rgba.end(), texel.begin(), texel.end());
    return result;
}

TEST(Requirements, OfNothingAreNothing) {
    const Requirements needs = find_requirements(Scene());
    EXPECT_EQ(needs.triangles, 0u);
    EXPECT_EQ(needs.instances, 0u);
    EXPECT_FALSE(needs.environment || needs.glossy || needs.mirror);
    EXPECT_EQ(needs.max_depth, 0u);
}

TEST(Requirements, CountWhatInstancesUse) {
    Scene scene;
    test::add(scene, unit_quad(), test::lambert(glm::vec3(0.5f)));
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 0), test::emitter(glm::vec3(2.0f)));
    scene.instances.push_back(scene.instances[1]);  // the sphere again
    scene.materials.push_back(test::mirror());      // used by nobody
    scene.meshes.push_back(unit_quad());            // used by nobody
    scene.lights.resize(3);
    scene.environment = {0.0f, 0.0f, 1.0f};
    const Requirements needs = find_requirements(scene);
    EXPECT_EQ(needs.triangles, 2u + 20u + 20u);
    EXPECT_EQ(needs.vertices, 4u + 12u + 12u);
    EXPECT_EQ(needs.instances, 3u);
    EXPECT_EQ(needs.materials, 2u);
    EXPECT_EQ(needs.emissive_triangles, 40u);
    EXPECT_EQ(needs.punctual_lights, 3u);
    EXPECT_TRUE(needs.environment);
    EXPECT_FALSE(needs.mirror) << "a mirror that nobody uses";
}

TEST(Requirements, CountTexturesThatMaterialsInUseReferTo) {
    Scene scene;
    scene.textures = {texture({{1, 2, 3, 4}, {5, 6, 7, 8}}), texture({{9, 9, 9, 9}}),
                      texture({{0, 0, 0, 0}})};
    Material textured = test::lambert(glm::vec3(1.0f));
    textured.base_colour_texture.texture = 0;
    textured.emissive_texture.texture = 0;
    test::add(scene, unit_quad(), textured);
    Material unused = textured;
    unused.base_colour_texture.texture = 1;
    scene.materials.push_back(unused);
    const Requirements needs = find_requirements(scene);
    EXPECT_EQ(needs.textures, 1u);
    EXPECT_EQ(needs.texels, 2u);
}

TEST(Requirements, TellMirrorsFromGlossyAndMatteSurfaces) {
    const Scene scene;
    const float limit = interop::SPECULAR_ROUGHNESS;
    EXPECT_TRUE(may_be_mirror(scene, test::mirror()));
    EXPECT_FALSE(may_be_glossy(scene, test::mirror()));
    EXPECT_FALSE(may_be_mirror(scene, test::glossy_metal(limit)));
    EXPECT_TRUE(may_be_glossy(scene, test::glossy_metal(limit)));
    EXPECT_TRUE(may_be_mirror(scene, test::glossy_metal(0.99f * limit)));
    EXPECT_FALSE(may_be_mirror(scene, test::lambert(glm::vec3(0.5f))));
    EXPECT_FALSE(may_be_glossy(scene, test::lambert(glm::vec3(0.5f))));
    Material varnish = test::lambert(glm::vec3(0.5f));
    varnish.specular = 1.0f;
    varnish.roughness = 0.0f;
    EXPECT_TRUE(may_be_mirror(scene, varnish)) << "a smooth dielectric";
}

TEST(Requirements, ReadRoughnessAndMetalnessFromTextures) {
    Scene scene;
    // Green is roughness, blue metalness; the material's factors scale them.
    scene.textures = {texture({{0, 0, 255, 255}, {0, 255, 255, 255}}), texture({{0, 255, 0, 255}})};
    Material mixed = test::mirror();
    mixed.roughness = 1.0f;
    mixed.metallic_roughness_texture.texture = 0;
    EXPECT_TRUE(may_be_mirror(scene, mixed)) << "its first texel";
    EXPECT_TRUE(may_be_glossy(scene, mixed)) << "its second texel";
    Material matte = test::mirror();
    matte.specular = 0.0f;
    matte.metallic_roughness_texture.texture = 1;
    EXPECT_FALSE(may_be_mirror(scene, matte)) << "a metalness of zero everywhere";
    EXPECT_FALSE(may_be_glossy(scene, matte));
}

// The alpha of the specular texture scales what a dielectric reflects.
TEST(Requirements, ReadStrengthOfReflectionsFromTextures) {
    Scene scene;
    scene.textures = {texture({{255, 255, 255, 0}, {255, 255, 255, 0}}),
                      texture({{255, 255, 255, 0}, {255, 255, 255, 1}})};
    Material varnish = test::lambert(glm::vec3(0.5f));
    varnish.specular = 1.0f;
    varnish.specular_texture.texture = 0;
    EXPECT_FALSE(may_be_glossy(scene, varnish));
    varnish.specular_texture.texture = 1;
    EXPECT_TRUE(may_be_glossy(scene, varnish));
    // A black reflection straight on is a white one at grazing angles.
    varnish.specular_texture.texture = -1;
    varnish.specular_colour = glm::vec3(0.0f);
    EXPECT_TRUE(may_be_glossy(scene, varnish));
}

// A factor is left at its default 1, and a texture decides.
TEST(Requirements, TellWhereSomethingIsDiffuse) {
    Scene scene;
    for (const int blue : {255, 128}) {
        Texture texture;
        texture.width = 2;
        texture.height = 1;
        texture.rgba = {0, 128, 255, 255, 0, 128, static_cast<std::uint8_t>(blue), 255};
        scene.textures.push_back(texture);
        Material material;
        material.metallic_roughness_texture.texture = static_cast<std::int32_t>(scene.textures.size() - 1);
        material.base_colour = glm::vec3(0.5f);
        material.metallic = 1.0f;
        scene.materials.push_back(material);
    }
    Material black;
    black.base_colour = glm::vec3(0.0f);
    black.metallic = 0.0f;
    Material paint;
    paint.base_colour = glm::vec3(0.5f);
    paint.metallic = 0.5f;
    scene.materials.insert(scene.materials.end(), {black, paint});
    EXPECT_EQ(find_requirements(scene).diffuse, (std::vector<bool>{false, true, false, true}));
}

TEST(Requirements, TellTheLeastAndMostOfEachChannel) {
    const TextureRange range = find_texture_range(texture({{9, 20, 31, 255}, {7, 22, 30, 254}}));
    EXPECT_THAT(range.least, ElementsAre(7, 20, 30, 254));
    EXPECT_THAT(range.most, ElementsAre(9, 22, 31, 255));
}

// Ranges that are not those of the textures show which of them are looked for.
TEST(Requirements, TakeRangesOfTexturesThatAreKnown) {
    Scene scene;
    scene.textures = {texture({{0, 255, 255, 255}}), texture({{0, 255, 255, 255}}), texture({{1, 2, 3, 4}})};
    Material metal = test::glossy_metal(1.0f);
    for (const std::int32_t i : {0, 1, 0}) {
        metal.metallic_roughness_texture.texture = i;
        test::add(scene, unit_quad(), metal);
    }
    TextureRanges ranges(3);
    ranges[0] = TextureRange{{0, 0, 255, 255}, {0, 0, 255, 255}};
    const Requirements needs = find_requirements_but_depth(scene, ranges);
    EXPECT_THAT(needs.reflective_instances, ElementsAre(0, 2)) << "as smooth as the range says";
    EXPECT_EQ(needs.roughness[0].most, 0.0f);
    EXPECT_EQ(needs.roughness[1].least, 1.0f);
    EXPECT_EQ(ranges[1], find_texture_range(scene.textures[1])) << "found, and kept";
    EXPECT_FALSE(ranges[2]) << "nobody asked for it";
}

TEST(Requirements, BoundTheChainsOfMirrorsInOnePlane) {
    Scene scene;
    test::add(scene, unit_quad(), test::mirror());
    test::add(scene, test::quad({3, 2, 0}, {1, 0, 0}, {0, 1, 0}), test::mirror());
    Requirements needs = find_requirements(scene);
    EXPECT_EQ(needs.max_depth, 1u);
    EXPECT_THAT(needs.reflective_instances, ElementsAre(0, 1));

    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1.0), {0.0, 0.0, 1e-3});
    EXPECT_EQ(find_requirements(scene).max_depth, kUnboundedDepth) << "a millimetre off the plane";
}

TEST(Requirements, BoundMirrorsFarOutTheSame) {
    Scene scene;
    test::add(scene, unit_quad(), test::mirror());
    scene.instances[0].world_from_object = glm::translate(glm::dmat4(1.0), {1e6, 1e6, 1e6});
    EXPECT_EQ(find_requirements(scene).max_depth, 1u);
}

TEST(Requirements, DoNotBoundCurvedMirrors) {
    Scene scene;
    test::add(scene, test::icosphere(glm::vec3(0.0f), 1.0f, 1), test::mirror());
    EXPECT_EQ(find_requirements(scene).max_depth, kUnboundedDepth);
}

TEST(Requirements, CountGlossyLobesAsReflections) {
    Scene scene;
    test::add(scene, unit_quad(), test::glossy_metal(0.5f));
    EXPECT_EQ(find_requirements(scene).max_depth, 1u);
    EXPECT_THAT(find_requirements(scene).reflective_instances, IsEmpty());
    EXPECT_THAT(find_requirements(scene).glossy_instances, ElementsAre(0));
    test::add(scene, test::quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), test::mirror());
    EXPECT_EQ(find_requirements(scene).max_depth, kUnboundedDepth) << "off the plane of the mirror";
}

TEST(Requirements, PassOverReflectorsWithoutTriangles) {
    Scene scene;
    test::add(scene, Mesh(), test::mirror());
    test::add(scene, Mesh(), test::glossy_metal(0.5f));
    const Requirements needs = find_requirements(scene);
    EXPECT_THAT(needs.reflective_instances, IsEmpty());
    EXPECT_THAT(needs.glossy_instances, IsEmpty());
    EXPECT_FALSE(needs.mirror);
}

}  // namespace
}  // namespace utsuri
