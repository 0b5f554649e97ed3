// SPDX-License-Identifier: Apache-2.0
#include "import/document/uri.h"

#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A PNG of one row: red, then blue, opaque.
constexpr std::string_view kPngUri =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAADUlEQVR4nGP4"
    "zwAE/wEHAAH/4iOeWQAAAABJRU5ErkJggg==";

Bytes png_bytes() {
    return read_uri(SourceFile{"test"}, kPngUri, "png");
}

/// A triangle with texcoords whose base colour comes from images[0].
class TexturedFile : public GltfWriter {
  public:
    explicit TexturedFile(const Json& image) {
        add_triangle();
        primitive()["attributes"]["TEXCOORD_0"] = add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
        primitive()["material"] = 0;
        json["materials"] = Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
        json["textures"] = Json::array({{{"source", 0}}});
        json["images"] = Json::array({image});
    }
};

void expect_red_and_blue(const ImportResult& result) {
    ASSERT_EQ(result.scene.textures.size(), 1u);
    const Texture& texture = result.scene.textures[0];
    EXPECT_EQ(texture.width, 2u);
    EXPECT_EQ(texture.height, 1u);
    EXPECT_THAT(texture.rgba, ElementsAre(255, 0, 0, 255, 0, 0, 255, 255));
    EXPECT_EQ(result.scene.materials.at(0).base_colour_texture.texture, 0);
}

TEST(Images, DataUri) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    expect_red_and_blue(file.import());
}

TEST(Images, ExternalFileWithPercentEncodedName) {
    TexturedFile file(Json::object({{"uri", "red%20and%20blue.png"}}));
    write_bytes(file.folder() / "red and blue.png", png_bytes());
    const ImportResult result = file.import();
    expect_red_and_blue(result);
    EXPECT_EQ(result.scene.textures.at(0).name, "red and blue.png");
}

TEST(Images, BufferView) {
    TexturedFile file(Json::object({{"mimeType", "image/png"}, {"name", "embedded"}}));
    file.json["images"][0]["bufferView"] = file.add_view(png_bytes());
    expect_red_and_blue(import_gltf(file.write_gltf()));
    file.json.erase("buffers");
    const ImportResult result = import_gltf(file.write_glb());
    expect_red_and_blue(result);
    EXPECT_EQ(result.scene.textures.at(0).name, "embedded");
}

TEST(Images, SharedByTexturesIsDecodedOnce) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    file.add("textures", {{"source", 0}});
    file.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
    file.json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    file.json["materials"][0]["extensions"]["KHR_materials_specular"] = {
        {"specularTexture", {{"index", 1}}}, {"specularColorTexture", {{"index", 0}}}};
    const ImportResult result = file.import();
    EXPECT_EQ(result.scene.textures.size(), 1u);
    EXPECT_EQ(result.scene.materials.at(0).emissive_texture.texture, 0);
    EXPECT_EQ(result.scene.materials.at(0).metallic_roughness_texture.texture, 0);
    EXPECT_EQ(result.scene.materials.at(0).specular_texture.texture, 0);
    EXPECT_EQ(result.scene.materials.at(0).specular_colour_texture.texture, 0);
}

TEST(Images, UnusedOnesAreNotEvenRead) {
    TexturedFile file(Json::object({{"uri", "absent.png"}}));
    file.json["materials"][0]["pbrMetallicRoughness"].erase("baseColorTexture");
    file.json["materials"][0]["normalTexture"] = {{"index", 0}};
    EXPECT_EQ(import_error(file), "");
}

TEST(Images, MissingFile) {
    TexturedFile file(Json::object({{"uri", "absent.png"}}));
    EXPECT_THAT(import_error(file), AllOf(HasSubstr("scene.gltf: images[0].uri"), HasSubstr("absent.png")));
}

TEST(Images, Undecodable) {
    TexturedFile file(Json::object({{"uri", "data:image/png;base64,AAAA"}}));
    EXPECT_THAT(import_error(file), AllOf(HasSubstr("scene.gltf"), HasSubstr("images[0]")));
}

TEST(Images, NeedOneSource) {
    TexturedFile file(Json::object());
    EXPECT_THAT(import_error(file), HasSubstr("images[0]: has both or neither of uri and bufferView"));
    file.json["images"][0] = {{"uri", kPngUri}, {"bufferView", 0}};
    EXPECT_THAT(import_error(file), HasSubstr("images[0]: has both or neither"));
}

TEST(Samplers, DefaultsAreRepeatAndLinear) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    const TextureSlot slot = file.import().scene.materials.at(0).base_colour_texture;
    EXPECT_EQ(slot.wrap_s, TextureWrap::repeat);
    EXPECT_EQ(slot.wrap_t, TextureWrap::repeat);
    EXPECT_EQ(slot.filter, TextureFilter::linear);
}

TEST(Samplers, WrapAndFilterAreRead) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    file.json["textures"][0]["sampler"] = 0;
    file.json["samplers"] =
        Json::array({{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}}});
    TextureSlot slot = file.import().scene.materials.at(0).base_colour_texture;
    EXPECT_EQ(slot.wrap_s, TextureWrap::clamp_to_edge);
    EXPECT_EQ(slot.wrap_t, TextureWrap::mirrored_repeat);
    EXPECT_EQ(slot.filter, TextureFilter::nearest);
    file.json["samplers"][0] = {{"magFilter", 9729}};
    slot = file.import().scene.materials.at(0).base_colour_texture;
    EXPECT_EQ(slot.wrap_s, TextureWrap::repeat);
    EXPECT_EQ(slot.filter, TextureFilter::linear);
    file.json["samplers"][0] = {{"wrapS", 1}};
    EXPECT_THAT(import_error(file), HasSubstr("samplers[0].wrapS: is 1; must be one of 10497, 33071, 33648"));
}

TEST(TextureReferences, OtherTexcoordSetsAreNotDrawn) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    const ImportResult result = file.import();
    EXPECT_FALSE(result.scene.materials.at(0).base_colour_texture.used());
    EXPECT_THAT(result.ignored, Contains("textures on a texCoord set other than 0 are not drawn: "
                                         "materials[0].pbrMetallicRoughness.baseColorTexture"));
}

TEST(TextureReferences, WithoutSourceAreNotDrawn) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    file.json["textures"][0].erase("source");
    const ImportResult result = file.import();
    EXPECT_FALSE(result.scene.materials.at(0).base_colour_texture.used());
    EXPECT_THAT(result.ignored, Contains(HasSubstr("textures without a source image are not drawn")));
}

TEST(TextureReferences, MeshWithoutTexcoordsIsListed) {
    TexturedFile file(Json::object({{"uri", kPngUri}}));
    file.primitive()["attributes"].erase("TEXCOORD_0");
    EXPECT_THAT(file.import().ignored,
                Contains("textures on meshes without TEXCOORD_0 are looked up at (0, 0): nodes[0]"));
}

/// A PNG of one row of two black texels.
constexpr std::string_view kBlackPngUri =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAC0lEQVR42mNgAAMAAAcAAS"
    "Ei2xMAAAAASUVORK5CYII=";

TEST(EmissiveTextures, ThatAreBlackGiveNoLight) {
    TexturedFile file(Json::object({{"uri", std::string(kBlackPngUri)}}));
    file.json["materials"] =
        Json::array({{{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}}});
    const ImportResult black = file.import();
    EXPECT_EQ(black.scene.materials.at(0).emissive, glm::vec3(0));
    EXPECT_FALSE(black.scene.materials.at(0).emissive_texture.used());
    EXPECT_EQ(black.scene.environment, glm::vec3(1));
    EXPECT_THAT(black.ignored,
                Contains("emissive textures that are black all over give no light: materials[0]"));
    file.json["images"][0]["uri"] = kPngUri;
    const ImportResult coloured = file.import();
    EXPECT_EQ(coloured.scene.materials.at(0).emissive, glm::vec3(1));
    EXPECT_EQ(coloured.scene.environment, glm::vec3(0));
}

}  // namespace
}  // namespace utsuri::test
