// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A square of side 1 in the plane z = 0 as four vertices in strip order.
const std::vector<float> kSquareStrip = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

std::vector<glm::vec3> facing_up(std::size_t count) {
    return std::vector<glm::vec3>(count, glm::vec3(0, 0, 1));
}

TEST(Topologies, StripKeepsTheFront) {
    GltfWriter writer;
    writer.add_mesh(kSquareStrip)["mode"] = 5;
    const ImportResult result = writer.import();
    const Mesh& mesh = result.scene.meshes.at(0);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.normals, facing_up(6));
}

TEST(Topologies, FanKeepsTheFront) {
    GltfWriter writer;
    writer.add_mesh({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 0.5f, 0})["mode"] = 6;
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.meshes.at(0).triangles.size(), 3u);
    EXPECT_EQ(result.scene.meshes.at(0).normals, facing_up(9));
}

TEST(Topologies, IndexedStrip) {
    GltfWriter writer;
    writer.add_mesh({1, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0})["mode"] = 5;
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({3, 2, 1, 0}, "SCALAR");
    EXPECT_EQ(writer.import().scene.meshes.at(0).normals, facing_up(6));
}

TEST(Topologies, PointsAndLinesAreIgnoredAloud) {
    for (const auto& [mode, name] : {std::pair{0, "points"}, {1, "lines"}, {2, "lines"}, {3, "lines"}}) {
        GltfWriter writer;
        writer.add_triangle()["mode"] = mode;
        const ImportResult result = writer.import();
        EXPECT_THAT(result.scene.meshes, IsEmpty());
        EXPECT_THAT(result.ignored,
                    ElementsAre(fmt::format("{} are not drawn: meshes[0].primitives[0]", name)));
    }
}

TEST(Topologies, VerticesLeftOverAreDropped) {
    GltfWriter writer;
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5});
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.meshes.at(0).triangles.size(), 1u);
    EXPECT_THAT(result.dropped,
                ElementsAre(AllOf(HasSubstr("meshes[0].primitives[0]"), HasSubstr("1 vertex reference"))));
}

TEST(Attributes, PositionIsRequired) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["attributes"] = {{"NORMAL", 0}};
    EXPECT_THAT(import_error(writer), HasSubstr("meshes[0].primitives[0].attributes.POSITION: missing"));
}

TEST(Attributes, UnusedOnesAreListed) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["attributes"]["COLOR_0"] = 0;
    writer.primitive()["attributes"]["TEXCOORD_1"] = 0;
    writer.primitive()["targets"] = Json::array({{{"POSITION", 0}}});
    EXPECT_THAT(
        writer.import().ignored,
        ElementsAre("vertex colours are not drawn: meshes[0].primitives[0]",
                    "texture coordinate sets other than TEXCOORD_0 are not used: meshes[0].primitives[0]",
                    "morph targets are not applied, the base shape is drawn: meshes[0].primitives[0]"));
}

TEST(Vertices, UnusedOnesAreDropped) {
    GltfWriter writer;
    writer.add_mesh({kNan, 0, 0, 0, 0, 0, 7, 7, 7, 1, 0, 0, 0, 1, 0, 8, 8, 8});
    writer.primitive()["indices"] = writer.add_accessor<std::uint16_t>({1, 3, 4, 3, 1, 4}, "SCALAR");
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC3");
    const ImportResult result = writer.import();
    const Mesh& mesh = result.scene.meshes.at(0);
    EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)));
    EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(1, 0, 2)));
    EXPECT_THAT(result.dropped, IsEmpty());
}

TEST(Vertices, PrimitivesMayShareAccessors) {
    GltfWriter writer;
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2});
    Json second = writer.primitive();
    writer.primitive()["indices"] = writer.add_accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
    second["indices"] = writer.add_accessor<std::uint16_t>({3, 4, 5}, "SCALAR");
    writer.json["meshes"][0]["primitives"].push_back(second);
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.meshes.size(), 2u);
    EXPECT_EQ(result.scene.meshes[0].positions.at(0), glm::vec3(0, 0, 0));
    EXPECT_EQ(result.scene.meshes[1].positions.at(0), glm::vec3(0, 0, 2));
    EXPECT_NE(result.scene.instances.at(0).name, result.scene.instances.at(1).name);
}

TEST(Normals, FlatWhereMissing) {
    GltfWriter writer;
    // Two faces of a tetrahedron that share an edge.
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({0, 2, 1, 1, 2, 3}, "SCALAR");
    const ImportResult result = writer.import();
    const Mesh& mesh = result.scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 6u);
    const float third = 1.0f / std::sqrt(3.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh.normals.at(i), glm::vec3(0, 0, -1));
        EXPECT_LT(glm::distance(mesh.normals.at(3 + i), glm::vec3(third)), kFloatTolerance);
    }
    EXPECT_THAT(result.added,
                ::testing::Contains("no NORMAL attribute, flat normals made: meshes[0].primitives[0]"));
}

TEST(Normals, BrokenOnesAreRepairedFromTheTriangles) {
    GltfWriter writer;
    // Vertex 0 lies between a triangle in z = 0 of area 1/2 and one in x = 0 of area 1.
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2});
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>({0, 0, 0, 0, 0, 2, kNan, 0, 0, kInfinity, 0, 0}, "VEC3");
    const ImportResult result = writer.import();
    const Mesh& mesh = result.scene.meshes.at(0);
    const glm::vec3 mean = glm::normalize(glm::vec3(2, 0, 1));
    EXPECT_LT(glm::distance(mesh.normals.at(0), mean), kFloatTolerance);
    EXPECT_EQ(mesh.normals.at(1), glm::vec3(0, 0, 1));
    EXPECT_LT(glm::distance(mesh.normals.at(2), mean), kFloatTolerance);
    EXPECT_EQ(mesh.normals.at(3), glm::vec3(1, 0, 0));
    EXPECT_THAT(result.added, ::testing::Contains(HasSubstr("3 normals of zero length or not finite")));
}

TEST(Normals, OpposedTrianglesStillGiveANormal) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({0, 1, 2, 0, 2, 1}, "SCALAR");
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>(std::vector<float>(9, 0.0f), "VEC3");
    const ImportResult result = writer.import();
    for (const glm::vec3 normal : result.scene.meshes.at(0).normals)
        EXPECT_EQ(std::abs(normal.z), 1.0f);
}

TEST(Normals, TinyOnesAreMadeUnit) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>({1e-30f, 0, 0, 0, 1e30f, 0, 3, 0, 4}, "VEC3");
    const ImportResult result = writer.import();
    EXPECT_THAT(result.scene.meshes.at(0).normals,
                ElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0.6f, 0, 0.8f)));
}

TEST(Drops, NonFiniteVerticesAndZeroAreaAreCounted) {
    GltfWriter writer;
    writer.add_mesh({
        0,    0, 0,          1,      0, 0, 0, 1,      0,  // good
        kNan, 0, 0,          1,      0, 0, 0, 1,      0,  // not a number
        0,    0, -kInfinity, 1,      0, 0, 0, 1,      0,  // infinite
        0,    0, 0,          1,      1, 1, 2, 2,      2,  // collinear
        3,    3, 3,          3,      3, 3, 4, 5,      6,  // two corners equal
        0,    0, 0,          1e-30f, 0, 0, 0, 1e-30f, 0   // tiny but of non-zero area
    });
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.meshes.at(0).triangles.size(), 2u);
    EXPECT_THAT(result.dropped,
                ElementsAre("meshes[0].primitives[0]: 2 triangles with a vertex that is not finite dropped",
                            "meshes[0].primitives[0]: 2 triangles of zero area dropped"));
    for (const glm::vec3 p : result.scene.meshes[0].positions)
        EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
}

TEST(Drops, EqualIndices) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({0, 1, 1, 0, 1, 2}, "SCALAR");
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.meshes.at(0).triangles.size(), 1u);
    EXPECT_THAT(result.dropped, ElementsAre(HasSubstr("1 triangle of zero area dropped")));
}

TEST(Drops, NothingLeftMeansNoInstance) {
    GltfWriter writer;
    writer.add_mesh({0, 0, 0, 1, 1, 1, 2, 2, 2});
    const ImportResult result = writer.import();
    EXPECT_THAT(result.scene.meshes, IsEmpty());
    EXPECT_THAT(result.scene.instances, IsEmpty());
}

TEST(Drops, NonFiniteTexcoordsAreReplaced) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["attributes"]["TEXCOORD_0"] =
        writer.add_accessor<float>({1, 1, kNan, 1, 2, kInfinity}, "VEC2");
    const ImportResult result = writer.import();
    EXPECT_THAT(result.scene.meshes.at(0).texcoords, ElementsAre(glm::vec2(1), glm::vec2(0), glm::vec2(0)));
    EXPECT_THAT(result.added, ::testing::Contains(HasSubstr("2 texture coordinates not finite")));
}

}  // namespace
}  // namespace utsuri::test
