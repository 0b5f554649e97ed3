// SPDX-License-Identifier: Apache-2.0
#include "import/document/uri.h"

#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string uri_error(std::string_view uri) {
    try {
        read_uri(SourceFile{"folder/scene.gltf"}, uri, "buffers[0].uri");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Uri, PercentDecoding) {
    EXPECT_EQ(percent_decode("a%20b%2fc%2F.png"), "a b/c/.png");
    EXPECT_EQ(percent_decode("100%.png"), "100%.png");
    EXPECT_EQ(percent_decode("%4"), "%4");
    EXPECT_EQ(percent_decode("%zz%41"), "%zzA");
    EXPECT_EQ(percent_decode("%E3%81%86"), "\xE3\x81\x86");
}

TEST(Uri, Base64KnownAnswers) {
    // RFC 4648, section 10
    const SourceFile file{"scene.gltf"};
    EXPECT_EQ(text_of(read_uri(file, "data:;base64,", "p")), "");
    EXPECT_EQ(text_of(read_uri(file, "data:;base64,Zg==", "p")), "f");
    EXPECT_EQ(text_of(read_uri(file, "data:;base64,Zm8=", "p")), "fo");
    EXPECT_EQ(text_of(read_uri(file, "data:text/plain;base64,Zm9v", "p")), "foo");
    EXPECT_EQ(text_of(read_uri(file, "data:application/gltf-buffer;base64,Zm9vYmFy", "p")), "foobar");
    EXPECT_EQ(text_of(read_uri(file, "data:;base64,Zm8", "p")), "fo");
    EXPECT_EQ(text_of(read_uri(file, "data:,a%20b", "p")), "a b");
}

TEST(Uri, WrongDataIsNamed) {
    EXPECT_THAT(uri_error("data:;base64,Zm9v*mFy"),
                AllOf(HasSubstr("buffers[0].uri"), HasSubstr("character 4 of the base64")));
    EXPECT_THAT(uri_error("data:;base64,Zm9vY"), HasSubstr("truncated base64 data"));
    EXPECT_THAT(uri_error("data:nothing"), HasSubstr("without a comma"));
    EXPECT_THAT(uri_error("https://example.org/a.bin"), HasSubstr("must be a relative path or a data: URI"));
    EXPECT_THAT(uri_error(""), HasSubstr("names no file"));
    EXPECT_THAT(uri_error("a%00b"), HasSubstr("names no file"));
}

TEST(BufferFiles, ExternalWithPercentEncodedName) {
    GltfWriter writer;
    writer.add_triangle();
    std::filesystem::create_directory(writer.folder() / "my data");
    write_bytes(writer.folder() / "my data" / "\xE3\x81\x86.bin", writer.bin);
    writer.json["buffers"] = {{{"byteLength", writer.bin.size()}, {"uri", "my%20data/%E3%81%86.bin"}}};
    EXPECT_EQ(writer.import().scene.meshes.size(), 1u);
}

TEST(BufferFiles, LongerThanDeclaredIsFine) {
    GltfWriter writer;
    writer.add_triangle();
    Bytes longer = writer.bin;
    longer.resize(longer.size() + 7);
    write_bytes(writer.folder() / "a.bin", longer);
    writer.json["buffers"] = {{{"byteLength", writer.bin.size()}, {"uri", "a.bin"}}};
    EXPECT_EQ(writer.import().scene.meshes.size(), 1u);
}

TEST(BufferFiles, ShorterThanDeclared) {
    GltfWriter writer;
    writer.add_triangle();
    write_bytes(writer.folder() / "a.bin", std::span(writer.bin).first(30));
    writer.json["buffers"] = {{{"byteLength", writer.bin.size()}, {"uri", "a.bin"}}};
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("buffers[0].byteLength"), HasSubstr("is 36, but there are 30 bytes")));
}

TEST(BufferFiles, Missing) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["buffers"] = {{{"byteLength", writer.bin.size()}, {"uri", "absent.bin"}}};
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("scene.gltf: buffers[0].uri"), HasSubstr("absent.bin")));
}

TEST(BufferFiles, NoUriOutsideGlb) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["buffers"] = {{{"byteLength", writer.bin.size()}}};
    EXPECT_THAT(import_error(writer), AllOf(HasSubstr("buffers[0].uri: missing"), HasSubstr("BIN chunk")));
}

TEST(BufferFiles, UnusedOnesAreNotRead) {
    GltfWriter writer;
    writer.add_triangle();
    writer.write_gltf();
    writer.json["buffers"].push_back({{"byteLength", 4}, {"uri", "absent.bin"}});
    EXPECT_EQ(import_error(writer), "");
}

}  // namespace
}  // namespace utsuri::test
