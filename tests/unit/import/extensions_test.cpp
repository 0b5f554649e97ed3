// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(RequiredExtensions, SupportedOnesPass) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["extensionsRequired"] = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                         "KHR_materials_ior", "KHR_materials_specular",
                                         "KHR_mesh_quantization"};
    writer.json["extensionsUsed"] = writer.json["extensionsRequired"];
    const ImportResult result = writer.import();
    EXPECT_THAT(result.ignored, IsEmpty());
}

TEST(RequiredExtensions, OthersAreNamedWithWhatIsSupported) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_draco_mesh_compression"};
    EXPECT_THAT(
        import_error(writer),
        AllOf(HasSubstr("extensionsRequired[1]: KHR_draco_mesh_compression is required but not supported"),
              HasSubstr("supported are KHR_lights_punctual, ")));
    writer.json["extensionsRequired"] = {5};
    EXPECT_THAT(import_error(writer), HasSubstr("extensionsRequired[0]"));
    writer.json["extensionsRequired"] = "KHR_materials_ior";
    EXPECT_THAT(import_error(writer), HasSubstr("extensionsRequired: is not an array"));
}

TEST(OptionalExtensions, AreListedWithTheirEffectAndPlace) {
    GltfWriter writer;
    writer.add_triangle()["material"] = 0;
    writer.json["materials"] =
        Json::array({{{"extensions",
                       {{"KHR_materials_transmission", Json::object()}, {"ACME_glitter", Json::object()}}}}});
    writer.json["extensionsUsed"] = {"KHR_materials_transmission", "ACME_glitter", "KHR_xmp_json_ld"};
    EXPECT_THAT(
        writer.import().ignored,
        ElementsAre("extension ACME_glitter is not supported: materials[0]",
                    "extension KHR_materials_transmission is not supported (transparent surfaces are drawn "
                    "opaque): materials[0]",
                    "extension KHR_xmp_json_ld is not supported: extensionsUsed[2]"));
}

TEST(OptionalExtensions, TextureTransformIsListedWhereItIs) {
    GltfWriter writer;
    writer.add_triangle()["material"] = 0;
    writer.json["textures"] = Json::array({Json::object()});
    const Json info = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
    writer.json["materials"] = Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", info}}}}});
    EXPECT_THAT(writer.import().ignored,
                ::testing::Contains(
                    "extension KHR_texture_transform is not supported (textures are drawn without "
                    "offset, rotation and scale): materials[0].pbrMetallicRoughness.baseColorTexture"));
}

TEST(OptionalExtensions, ThatHoldABufferAreNamed) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["buffers"] = {{{"byteLength", writer.bin.size()}}};
    writer.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("buffers[0].uri: missing"), HasSubstr("EXT_meshopt_compression")));
}

TEST(OptionalExtensions, PropertiesOfExtrasAreNotExtensions) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["extras"] = {{"extensions", {{"KHR_materials_clearcoat", Json::object()}}}};
    EXPECT_THAT(writer.import().ignored, IsEmpty());
}

}  // namespace
}  // namespace utsuri::test
