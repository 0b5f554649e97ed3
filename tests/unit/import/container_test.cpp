// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string error_of(const TemporaryFolder& folder, const char* name, std::span<const std::byte> bytes) {
    return import_error(write_bytes(folder.path() / name, bytes));
}

void put_u32(Bytes& bytes, std::size_t offset, std::uint32_t value) {
    std::memcpy(bytes.data() + offset, &value, sizeof(value));
}

TEST(Container, ReadsGlbWithBinChunk) {
    GltfWriter writer;
    writer.add_triangle();
    const ImportResult result = import_gltf(writer.write_glb());
    ASSERT_EQ(result.scene.meshes.size(), 1u);
    EXPECT_EQ(result.scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
}

TEST(Container, TellsGlbByContentWhateverTheExtension) {
    GltfWriter writer;
    writer.add_triangle();
    const auto path = write_bytes(writer.folder() / "scene.gltf", writer.glb());
    EXPECT_EQ(import_gltf(path).scene.meshes.size(), 1u);
}

TEST(Container, MissingFileIsNamed) {
    TemporaryFolder folder;
    EXPECT_THAT(import_error(folder.path() / "absent.gltf"),
                AllOf(StartsWith("import glTF"), HasSubstr("absent.gltf")));
}

TEST(Container, FolderIsNotAFile) {
    TemporaryFolder folder;
    EXPECT_THAT(import_error(folder.path()), HasSubstr(folder.path().string()));
}

TEST(Container, EmptyFile) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of(folder, "empty.gltf", {}),
                AllOf(HasSubstr("empty.gltf"), HasSubstr("the file is empty")));
}

TEST(Container, WrongMagic) {
    TemporaryFolder folder;
    GltfWriter writer;
    Bytes glb = writer.glb();
    glb[0] = std::byte{'G'};
    EXPECT_THAT(error_of(folder, "scene.glb", glb), HasSubstr("first four bytes must be \"glTF\""));
}

TEST(Container, WrongContainerVersion) {
    TemporaryFolder folder;
    GltfWriter writer;
    Bytes glb = writer.glb();
    put_u32(glb, 4, 1);
    EXPECT_THAT(error_of(folder, "scene.glb", glb), HasSubstr("binary container version 1; must be 2"));
}

TEST(Container, TruncatedHeader) {
    TemporaryFolder folder;
    GltfWriter writer;
    const Bytes glb = writer.glb();
    EXPECT_THAT(error_of(folder, "scene.glb", std::span(glb).first(8)), HasSubstr("truncated: 8 bytes"));
}

TEST(Container, TruncatedFile) {
    TemporaryFolder folder;
    GltfWriter writer;
    writer.add_triangle();
    const Bytes glb = writer.glb();
    const auto expected =
        fmt::format("the header says {} bytes, the file has {}", glb.size(), glb.size() - 4);
    EXPECT_THAT(error_of(folder, "scene.glb", std::span(glb).first(glb.size() - 4)), HasSubstr(expected));
}

TEST(Container, ChunkLongerThanFile) {
    TemporaryFolder folder;
    GltfWriter writer;
    Bytes glb = writer.glb();
    put_u32(glb, 12, 0xFFFFFFF0u);
    EXPECT_THAT(error_of(folder, "scene.glb", glb), HasSubstr("chunk 0 says 4294967280 bytes"));
}

TEST(Container, ChunkHeaderCutOff) {
    TemporaryFolder folder;
    Bytes glb = GltfWriter().glb();
    glb.resize(glb.size() + 4);
    put_u32(glb, 8, static_cast<std::uint32_t>(glb.size()));
    EXPECT_THAT(error_of(folder, "scene.glb", glb), HasSubstr("4 bytes left for the header of chunk 1"));
}

TEST(Container, HeaderLengthBelowHeader) {
    TemporaryFolder folder;
    Bytes glb = GltfWriter().glb();
    put_u32(glb, 8, 4);
    EXPECT_THAT(error_of(folder, "scene.glb", glb),
                HasSubstr("the header says 4 bytes; must be at least 12"));
    put_u32(glb, 8, 12);
    EXPECT_THAT(error_of(folder, "scene.glb", glb), HasSubstr("no JSON chunk"));
}

TEST(Container, FirstChunkMustBeJson) {
    TemporaryFolder folder;
    Bytes glb = GltfWriter().glb();
    put_u32(glb, 16, 0x004E4942u);
    EXPECT_THAT(error_of(folder, "scene.glb", glb),
                HasSubstr("the first chunk has type 0x004E4942; must be JSON"));
}

TEST(JsonText, SyntaxErrorHasLineAndColumn) {
    TemporaryFolder folder;
    const auto error = error_of(folder, "scene.gltf", bytes_of("{\n  \"asset\": {\"version\": \"2.0\" ]\n}"));
    EXPECT_THAT(error,
                AllOf(HasSubstr("scene.gltf"), HasSubstr("not valid JSON"), HasSubstr("line 2, column 30")));
}

TEST(JsonText, NumberBeyondDouble) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of(folder, "scene.gltf", bytes_of("{\"asset\": 1e999}")), HasSubstr("not valid JSON"));
}

TEST(JsonText, InvalidUtf8) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of(folder, "scene.gltf", bytes_of("{\"asset\": \"\xff\"}")),
                HasSubstr("not valid JSON"));
}

TEST(JsonText, DeepNestingIsRefusedBeforeItOverflowsAStack) {
    TemporaryFolder folder;
    const std::string deep(1'000'000, '[');
    EXPECT_THAT(error_of(folder, "scene.gltf", bytes_of("{\"extras\": " + deep)),
                HasSubstr("nested more than 128 deep"));
}

TEST(JsonText, RootMustBeObject) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of(folder, "scene.gltf", bytes_of("[1, 2]")), HasSubstr("must be a glTF 2.0 object"));
}

TEST(AssetVersion, MustBeThere) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of(folder, "a.gltf", bytes_of("{}")), HasSubstr("a.gltf: asset"));
    EXPECT_THAT(error_of(folder, "a.gltf", bytes_of("{\"asset\": {}}")), HasSubstr("asset.version: missing"));
    EXPECT_THAT(error_of(folder, "a.gltf", bytes_of("{\"asset\": {\"version\": 2.0}}")),
                HasSubstr("asset.version"));
}

TEST(AssetVersion, MustBeTwo) {
    GltfWriter writer;
    for (const char* version : {"1.0", "3.0", "2", "2.x", "", "-2.0", "20.0"}) {
        writer.json["asset"]["version"] = version;
        EXPECT_THAT(import_error(writer), AllOf(HasSubstr("asset.version"), HasSubstr("must be 2.x")))
            << version;
    }
    writer.json["asset"]["version"] = "2.1";
    EXPECT_EQ(import_error(writer), "");
    writer.json["asset"]["minVersion"] = "2.1";
    EXPECT_THAT(import_error(writer), HasSubstr("asset.minVersion: is \"2.1\"; must be \"2.0\""));
}

}  // namespace
}  // namespace utsuri::test
