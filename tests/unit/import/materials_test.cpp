// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A writer whose only triangle uses materials[0] as given.
struct MaterialFile {
    GltfWriter writer;

    explicit MaterialFile(const Json& material) {
        writer.add_triangle();
        writer.json["materials"] = Json::array({material});
        writer.primitive()["material"] = 0;
    }
    Material material() { return writer.import().scene.materials.at(0); }
    std::string error() { return import_error(writer); }
};

TEST(Materials, DefaultWhereNoneIsGiven) {
    GltfWriter writer;
    writer.add_triangle();
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.materials.size(), 1u);
    const Material& material = result.scene.materials[0];
    EXPECT_EQ(material.base_colour, glm::vec3(1));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_EQ(material.emissive, glm::vec3(0));
}

TEST(Materials, EmptyObjectHasTheDefaultsOfGltf) {
    const Material material = MaterialFile(Json::object()).material();
    EXPECT_EQ(material.name, "materials[0]");
    EXPECT_EQ(material.base_colour, glm::vec3(1));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_EQ(material.ior, 1.5f);
    EXPECT_EQ(material.specular, 1.0f);
    EXPECT_EQ(material.specular_colour, glm::vec3(1));
    EXPECT_FALSE(material.double_sided);
}

TEST(Materials, EveryValueIsRead) {
    const Material material =
        MaterialFile(Json::object({{"name", "brass"},
                                   {"pbrMetallicRoughness",
                                    {{"baseColorFactor", {0.25, 0.5, 0.75, 1}},
                                     {"metallicFactor", 0.125},
                                     {"roughnessFactor", 0.375}}},
                                   {"emissiveFactor", {0.5, 1, 0}},
                                   {"doubleSided", true},
                                   {"extensions",
                                    {{"KHR_materials_emissive_strength", {{"emissiveStrength", 10000000000}}},
                                     {"KHR_materials_ior", {{"ior", 1.25}}},
                                     {"KHR_materials_specular",
                                      {{"specularFactor", 0.25}, {"specularColorFactor", {0, 0.5, 2}}}}}}}))
            .material();
    EXPECT_EQ(material.name, "brass");
    EXPECT_EQ(material.base_colour, glm::vec3(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(material.metallic, 0.125f);
    EXPECT_EQ(material.roughness, 0.375f);
    EXPECT_EQ(material.emissive, glm::vec3(5e9f, 1e10f, 0));
    EXPECT_TRUE(material.double_sided);
    EXPECT_EQ(material.ior, 1.25f);
    EXPECT_EQ(material.specular, 0.25f);
    EXPECT_EQ(material.specular_colour, glm::vec3(0, 0.5f, 2));
}

TEST(Materials, OnlyUsedOnesAreImportedAndShared) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add_triangle();
    writer.json["materials"] = Json::array({{{"name", "unused"}}, {{"name", "used"}}});
    for (Json& mesh : writer.json["meshes"])
        mesh["primitives"][0]["material"] = 1;
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.materials.size(), 1u);
    EXPECT_EQ(result.scene.materials[0].name, "used");
    EXPECT_EQ(result.scene.instances.at(1).material, 0u);
}

TEST(Materials, ValuesOutOfRange) {
    EXPECT_THAT(
        MaterialFile(Json::object({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}})).error(),
        HasSubstr("materials[0].pbrMetallicRoughness.metallicFactor: is 1.5; must be a number in [0, 1]"));
    EXPECT_THAT(MaterialFile(Json::object({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, -0.5, 1}}}}}))
                    .error(),
                HasSubstr("materials[0].pbrMetallicRoughness.baseColorFactor[2]: is -0.5"));
    EXPECT_THAT(MaterialFile(Json::object({{"emissiveFactor", {1, 1}}})).error(),
                HasSubstr("materials[0].emissiveFactor: is array; must be an array of 3 numbers"));
    EXPECT_THAT(MaterialFile(Json::object({{"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}})).error(),
                HasSubstr("materials[0].extensions.KHR_materials_ior.ior: is 0.5; must be 0, or at least 1"));
    EXPECT_THAT(MaterialFile(Json::object({{"alphaMode", "GLASS"}})).error(),
                AllOf(HasSubstr("materials[0].alphaMode"), HasSubstr("one of OPAQUE, MASK, BLEND")));
    EXPECT_THAT(
        MaterialFile(Json::object({{"emissiveFactor", {1e30, 0, 0}},
                                   {"extensions",
                                    {{"KHR_materials_emissive_strength", {{"emissiveStrength", 1e30}}}}}}))
            .error(),
        HasSubstr("materials[0].emissiveFactor: times emissiveStrength"));
}

TEST(Materials, UnusedFeaturesAreListed) {
    MaterialFile file(Json::object({{"alphaMode", "BLEND"},
                                    {"normalTexture", {{"index", 0}}},
                                    {"occlusionTexture", {{"index", 0}}},
                                    {"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}}));
    file.writer.json["textures"] = Json::array({Json::object()});
    const ImportResult result = file.writer.import();
    EXPECT_THAT(result.ignored,
                ElementsAre("an ior of 0 (full reflection at every angle) is drawn as 1.5: materials[0]",
                            "normal textures are not drawn, surfaces look smooth: materials[0]",
                            "occlusion textures are not used, occlusion is computed: materials[0]",
                            "alphaMode BLEND is not used, surfaces are drawn opaque: materials[0]"));
    EXPECT_EQ(result.scene.materials.at(0).ior, 1.5f);
}

TEST(Materials, ManyPlacesAreCounted) {
    GltfWriter writer;
    for (int i = 0; i < 5; ++i) {
        writer.add_triangle()["material"] = i;
        writer.add("materials", {{"alphaMode", "MASK"}});
    }
    EXPECT_THAT(writer.import().ignored,
                ElementsAre("alphaMode MASK is not used, surfaces are drawn opaque: materials[0], "
                            "materials[1], materials[2] and 2 more"));
}

TEST(Surroundings, LightASceneWithoutLight) {
    GltfWriter writer;
    writer.add_triangle();
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.environment, glm::vec3(1));
    EXPECT_THAT(result.added, Contains("no light in the file: lit by a uniform environment of 1 cd/m2"));
}

TEST(Surroundings, AreDarkWhereSomethingEmits) {
    MaterialFile file(Json::object({{"emissiveFactor", {0, 0, 0.001}}}));
    const ImportResult result = file.writer.import();
    EXPECT_EQ(result.scene.environment, glm::vec3(0));
    EXPECT_THAT(result.added, Not(Contains(HasSubstr("no light"))));
}

TEST(Surroundings, AnEmissiveMaterialThatNothingUsesIsNoLight) {
    MaterialFile file(Json::object({{"emissiveFactor", {1, 1, 1}}}));
    file.writer.primitive().erase("material");
    EXPECT_EQ(file.writer.import().scene.environment, glm::vec3(1));
}

}  // namespace
}  // namespace utsuri::test
