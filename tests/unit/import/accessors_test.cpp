// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Mesh& only_mesh(const ImportResult& result) {
    EXPECT_EQ(result.scene.meshes.size(), 1u);
    return result.scene.meshes.at(0);
}

/// Positions (0,0,0), (a,0,0), (0,a,0) in any component type; vertices are unshared in order.
template <class Component>
float imported_extent(Component a, bool normalized) {
    GltfWriter writer;
    const Component o = 0;
    // Elements of three 8- or 16-bit components need a stride that is a multiple of 4.
    std::vector<Component> padded;
    const std::size_t slots = (3 * sizeof(Component) + 3) / 4 * 4 / sizeof(Component);
    for (const auto& vertex : {std::array{o, o, o}, std::array{a, o, o}, std::array{o, a, o}}) {
        padded.insert(padded.end(), vertex.begin(), vertex.end());
        padded.resize((padded.size() + slots - 1) / slots * slots);
    }
    const std::size_t view = writer.add_view(bytes_of(padded), slots * sizeof(Component));
    const std::size_t accessor = writer.add("accessors", {{"bufferView", view},
                                                          {"componentType", component_type<Component>()},
                                                          {"normalized", normalized},
                                                          {"count", 3},
                                                          {"type", "VEC3"}});
    writer.add_mesh_of(accessor);
    const ImportResult result = writer.import();
    return only_mesh(result).positions.at(1).x;
}

TEST(VertexComponents, EveryTypeOfPosition) {
    EXPECT_EQ(imported_extent<float>(2.5f, false), 2.5f);
    EXPECT_EQ(imported_extent<std::int8_t>(-100, false), -100.0f);
    EXPECT_EQ(imported_extent<std::uint8_t>(200, false), 200.0f);
    EXPECT_EQ(imported_extent<std::int16_t>(-30000, false), -30000.0f);
    EXPECT_EQ(imported_extent<std::uint16_t>(60000, false), 60000.0f);
}

TEST(VertexComponents, NormalizedIntegers) {
    EXPECT_EQ(imported_extent<std::int8_t>(127, true), 1.0f);
    EXPECT_EQ(imported_extent<std::int8_t>(-128, true), -1.0f);  // clamped: -128/127 is below -1
    EXPECT_EQ(imported_extent<std::uint8_t>(51, true), 51.0f / 255.0f);
    EXPECT_EQ(imported_extent<std::int16_t>(-32767, true), -1.0f);
    EXPECT_EQ(imported_extent<std::uint16_t>(13107, true), 13107.0f / 65535.0f);
}

template <class Component>
glm::vec2 imported_texcoord(Component u, Component v, bool normalized) {
    GltfWriter writer;
    writer.add_triangle();
    const std::size_t slots = sizeof(Component) == 1 ? 4 : 2;
    std::vector<Component> padded(3 * slots, Component{0});
    padded[slots] = u;
    padded[slots + 1] = v;
    const std::size_t view = writer.add_view(bytes_of(padded), slots * sizeof(Component));
    writer.primitive()["attributes"]["TEXCOORD_0"] =
        writer.add("accessors", {{"bufferView", view},
                                 {"componentType", component_type<Component>()},
                                 {"normalized", normalized},
                                 {"count", 3},
                                 {"type", "VEC2"}});
    const ImportResult result = writer.import();
    return only_mesh(result).texcoords.at(1);
}

TEST(VertexComponents, EveryTypeOfTexcoord) {
    EXPECT_EQ(imported_texcoord<float>(-0.25f, 3.5f, false), glm::vec2(-0.25f, 3.5f));
    EXPECT_EQ(imported_texcoord<std::uint8_t>(255, 0, true), glm::vec2(1, 0));
    EXPECT_EQ(imported_texcoord<std::uint16_t>(65535, 13107, true), glm::vec2(1.0f, 13107.0f / 65535.0f));
    EXPECT_EQ(imported_texcoord<std::int16_t>(-4, 7, false), glm::vec2(-4, 7));
}

TEST(VertexComponents, NormalizedByteNormalsAreMadeUnit) {
    GltfWriter writer;
    writer.add_triangle();
    const std::vector<std::int8_t> normals = {0, 0, 127, 0, 0, 100, 0, 0, 0, -128, 0, 0};
    const std::size_t view = writer.add_view(bytes_of(normals), 4);
    writer.primitive()["attributes"]["NORMAL"] = writer.add("accessors", {{"bufferView", view},
                                                                          {"componentType", 5120},
                                                                          {"normalized", true},
                                                                          {"count", 3},
                                                                          {"type", "VEC3"}});
    const ImportResult result = writer.import();
    EXPECT_THAT(only_mesh(result).normals,
                ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(0, -1, 0)));
}

TEST(Layout, InterleavedAttributesWithOffsets) {
    GltfWriter writer;
    // position (3), texcoord (2), padding (1): stride 24
    const std::vector<float> vertices = {0, 0, 0, 0.5f, 0.25f, 99, 2, 0, 0, 1, 0, 99, 0, 2, 0, 0, 1, 99};
    const std::size_t view = writer.add_view(bytes_of(vertices), 24);
    const Json base = {{"bufferView", view}, {"componentType", 5126}, {"count", 3}};
    Json positions = base;
    positions["type"] = "VEC3";
    Json texcoords = base;
    texcoords["type"] = "VEC2";
    texcoords["byteOffset"] = 12;
    writer.add_mesh_of(writer.add("accessors", positions));
    writer.primitive()["attributes"]["TEXCOORD_0"] = writer.add("accessors", texcoords);
    const ImportResult result = writer.import();
    EXPECT_THAT(only_mesh(result).positions,
                ElementsAre(glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0)));
    EXPECT_THAT(only_mesh(result).texcoords,
                ElementsAre(glm::vec2(0.5f, 0.25f), glm::vec2(1, 0), glm::vec2(0, 1)));
}

template <class Index>
void expect_indices_work() {
    GltfWriter writer;
    writer.add_mesh({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    writer.primitive()["indices"] = writer.add_accessor<Index>({2, 3, 1}, "SCALAR");
    const ImportResult result = writer.import();
    EXPECT_THAT(only_mesh(result).positions,
                ElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0)));
}

TEST(Indices, EveryType) {
    expect_indices_work<std::uint8_t>();
    expect_indices_work<std::uint16_t>();
    expect_indices_work<std::uint32_t>();
}

TEST(Indices, WrongTypeIsNamed) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["indices"] = writer.add_accessor<float>({0, 1, 2}, "SCALAR");
    EXPECT_THAT(import_error(writer), AllOf(HasSubstr("meshes[0].primitives[0].indices"),
                                            HasSubstr("is 5126"), HasSubstr("5121, 5123 or 5125")));
    writer.primitive()["indices"] = 0;
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[0].type must be SCALAR"));
}

TEST(Indices, StrideIsRefused) {
    GltfWriter writer;
    writer.add_triangle();
    const std::size_t view = writer.add_view(bytes_of(std::vector<std::uint32_t>{0, 1, 2}), 4);
    writer.primitive()["indices"] = writer.add(
        "accessors", {{"bufferView", view}, {"componentType", 5125}, {"count", 3}, {"type", "SCALAR"}});
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("bufferViews[1].byteStride"), HasSubstr("must be absent")));
}

TEST(Indices, OutOfRangeIsAnError) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["indices"] = writer.add_accessor<std::uint32_t>({0, 1, 4294967295u}, "SCALAR");
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("meshes[0].primitives[0].indices"),
                      HasSubstr("index 2 is 4294967295; must be below the number of vertices, 3")));
}

TEST(Indices, WithoutBufferViewAreRefused) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["indices"] =
        writer.add("accessors", {{"componentType", 5125}, {"count", 3}, {"type", "SCALAR"}});
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[1].bufferView: missing"));
}

Json sparse(std::size_t count, std::size_t indices, int index_type, std::size_t values) {
    return {{"count", count},
            {"indices", {{"bufferView", indices}, {"componentType", index_type}}},
            {"values", {{"bufferView", values}}}};
}

TEST(Sparse, ReplacesElementsOfAnAccessor) {
    GltfWriter writer;
    writer.add_triangle();
    const std::size_t indices = writer.add_view(bytes_of(std::vector<std::uint16_t>{0, 2}));
    const std::size_t values = writer.add_view(bytes_of(std::vector<float>{-1, 0, 0, 0, 5, 0}));
    writer.json["accessors"][0]["sparse"] = sparse(2, indices, 5123, values);
    const ImportResult result = writer.import();
    EXPECT_THAT(only_mesh(result).positions,
                ElementsAre(glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 5, 0)));
}

TEST(Sparse, OverZerosWhereThereIsNoBufferView) {
    GltfWriter writer;
    const std::size_t indices = writer.add_view(bytes_of(std::vector<std::uint8_t>{1, 2}));
    const std::size_t values = writer.add_view(bytes_of(std::vector<float>{3, 0, 0, 0, 3, 0}));
    writer.add_mesh_of(writer.add("accessors", {{"componentType", 5126},
                                                {"count", 3},
                                                {"type", "VEC3"},
                                                {"sparse", sparse(2, indices, 5121, values)}}));
    const ImportResult result = writer.import();
    EXPECT_THAT(only_mesh(result).positions,
                ElementsAre(glm::vec3(0), glm::vec3(3, 0, 0), glm::vec3(0, 3, 0)));
}

TEST(Sparse, HitsTheRightVertexWhenOnlyARunIsRead) {
    GltfWriter writer;
    writer.add_mesh({9, 9, 9, 9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({2, 3, 4}, "SCALAR");
    const std::size_t indices = writer.add_view(bytes_of(std::vector<std::uint32_t>{1, 3}));
    const std::size_t values = writer.add_view(bytes_of(std::vector<float>{7, 7, 7, 8, 0, 0}));
    writer.json["accessors"][0]["sparse"] = sparse(2, indices, 5125, values);
    const ImportResult result = writer.import();
    EXPECT_THAT(only_mesh(result).positions,
                ElementsAre(glm::vec3(0), glm::vec3(8, 0, 0), glm::vec3(0, 1, 0)));
}

TEST(Sparse, ReplacesIndices) {
    GltfWriter writer;
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::size_t accessor = writer.add_accessor<std::uint16_t>({0, 0, 0}, "SCALAR");
    const std::size_t indices = writer.add_view(bytes_of(std::vector<std::uint8_t>{1, 2}));
    const std::size_t values = writer.add_view(bytes_of(std::vector<std::uint16_t>{1, 2}));
    writer.json["accessors"][accessor]["sparse"] = sparse(2, indices, 5121, values);
    writer.primitive()["indices"] = accessor;
    EXPECT_EQ(only_mesh(writer.import()).triangles.size(), 1u);
}

TEST(Sparse, WrongIndicesAndSizesAreNamed) {
    GltfWriter writer;
    writer.add_triangle();
    const std::size_t indices = writer.add_view(bytes_of(std::vector<std::uint8_t>{0, 3}));
    const std::size_t values = writer.add_view(bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6}));
    writer.json["accessors"][0]["sparse"] = sparse(2, indices, 5121, values);
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("accessors[0].sparse.indices"), HasSubstr("index 1 is 3")));
    writer.json["accessors"][0]["sparse"]["count"] = 4;
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[0].sparse.count: is 4; must be at most"));
    writer.json["accessors"][0]["sparse"]["count"] = 3;
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[0].sparse.indices.bufferView"));
    writer.json["accessors"][0]["sparse"]["indices"]["bufferView"] = 0;
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[0].sparse.values.bufferView"));
}

TEST(Layout, ViewPastItsBuffer) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["bufferViews"][0]["byteLength"] = 40;
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("bufferViews[0].byteLength"), HasSubstr("ends at byte 40"),
                      HasSubstr("36 bytes of buffers[0]")));
}

TEST(Layout, AccessorPastItsView) {
    GltfWriter writer;
    writer.add_triangle();
    for (const Json& count : {Json(4), Json(4294967295u), Json(9007199254740991)}) {
        writer.json["accessors"][0]["count"] = count;
        EXPECT_THAT(import_error(writer), AllOf(HasSubstr("accessors[0].bufferView"), HasSubstr("36 bytes")))
            << count;
    }
    writer.json["accessors"][0]["count"] = 1e18;
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[0].count"));
    writer.json["accessors"][0]["count"] = 3;
    writer.json["accessors"][0]["byteOffset"] = 4;
    EXPECT_THAT(import_error(writer), HasSubstr("accessors[0].bufferView"));
}

TEST(Layout, ZeroFilledAccessorsAreBounded) {
    GltfWriter writer;
    writer.add_mesh_of(
        writer.add("accessors", {{"componentType", 5126}, {"count", 4294967295u}, {"type", "VEC3"}}));
    EXPECT_THAT(import_error(writer),
                HasSubstr("accessors[0].count: is 4294967295; must be at most 16777216"));
}

TEST(Layout, StrideBelowElement) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["bufferViews"][0]["byteStride"] = 8;
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("bufferViews[0].byteStride"), HasSubstr("is 8; must be at least 12")));
    writer.json["bufferViews"][0]["byteStride"] = 14;
    EXPECT_THAT(import_error(writer),
                HasSubstr("bufferViews[0].byteStride: is 14; must be an integer in [0, 252] and a "
                          "multiple of 4"));
}

TEST(Layout, StrideOfZeroIsPacked) {
    GltfWriter writer;
    writer.add_triangle();
    const std::vector<glm::vec3> packed = only_mesh(writer.import()).positions;
    writer.json["bufferViews"][0]["byteStride"] = 0;
    const ImportResult result = writer.import();
    EXPECT_EQ(only_mesh(result).positions, packed);
    EXPECT_THAT(result.ignored,
                Contains("a byteStride of 0 is read as none, elements are packed: bufferViews[0]"));
}

TEST(VertexComponents, WrongTypesAreNamed) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["accessors"][0]["type"] = "VEC2";
    EXPECT_THAT(import_error(writer), AllOf(HasSubstr("meshes[0].primitives[0].attributes.POSITION"),
                                            HasSubstr("accessors[0].type must be VEC3")));
    writer.json["accessors"][0]["type"] = "VEC3";
    writer.json["accessors"][0]["componentType"] = 5125;
    EXPECT_THAT(import_error(writer), HasSubstr("componentType is 5125"));
    writer.json["accessors"][0]["componentType"] = 5126;
    writer.primitive()["attributes"]["NORMAL"] = writer.add_accessor<float>({0, 0, 1}, "VEC3");
    writer.json.erase("buffers");
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("meshes[0].primitives[0].attributes.NORMAL"),
                      HasSubstr("accessors[1] has 1 elements"), HasSubstr("3 vertices")));
}

}  // namespace
}  // namespace utsuri::test
