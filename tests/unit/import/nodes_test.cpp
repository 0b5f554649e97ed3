// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Roundings of a few float64 products of numbers near 1.
constexpr double kTransformTolerance = 1e-14;

glm::dvec3 placed(const ImportResult& result, glm::dvec3 point, std::size_t instance = 0) {
    return glm::dvec3(result.scene.instances.at(instance).world_from_object * glm::dvec4(point, 1.0));
}

TEST(Transforms, ScaleThenRotationThenTranslation) {
    GltfWriter writer;
    writer.add_triangle();
    const double half = std::sqrt(0.5);
    Json& node = writer.json["nodes"][0];
    node["translation"] = {10, 20, 30};
    node["rotation"] = {0, 0, half, half};  // 90 degrees about +Z
    node["scale"] = {2, 3, 4};
    const ImportResult result = writer.import();
    expect_near(placed(result, {1, 0, 0}), {10, 22, 30}, 100 * kTransformTolerance);
    expect_near(placed(result, {0, 1, 1}), {7, 20, 34}, 100 * kTransformTolerance);
}

TEST(Transforms, MatrixIsColumnMajorAndMayMirror) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["matrix"] = {0, 1, 0, 0, 1, 0, 0, 0, 0.5, 0, 1, 0, 7, 8, 9, 1};
    const ImportResult result = writer.import();
    expect_near(placed(result, {1, 2, 4}), {11, 9, 13}, 0.0);
    EXPECT_LT(glm::determinant(glm::dmat3(result.scene.instances.at(0).world_from_object)), 0.0);
}

TEST(Transforms, ComposedInFloat64) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["translation"] = {1.0, 0, 0};
    writer.add("nodes", {{"children", {0}}, {"translation", {1e15, 0, 0}}});
    const ImportResult result = writer.import();
    EXPECT_EQ(placed(result, {0, 0, 0}).x, 1e15 + 1.0);  // float32 would give 1e15
}

TEST(Transforms, RotationIsNormalized) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["rotation"] = {0, 0, 3, 3};
    expect_near(placed(writer.import(), {1, 0, 0}), {0, 1, 0}, kTransformTolerance);
    writer.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    EXPECT_THAT(import_error(writer),
                HasSubstr("nodes[0].rotation: has length 0; must be a unit quaternion"));
}

TEST(Transforms, MatrixMustBeAffine) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_THAT(import_error(writer), HasSubstr("nodes[0].matrix[7]: is 0.5; must be 0"));
}

TEST(Transforms, NonFiniteProductIsAnError) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["scale"] = {1e200, 1, 1};
    writer.add("nodes", {{"children", {0}}, {"scale", {1e200, 1, 1}}});
    EXPECT_THAT(import_error(writer), AllOf(HasSubstr("nodes[0]"), HasSubstr("is not finite")));
}

TEST(Transforms, GeometryBeyondFloat32IsAnError) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["scale"] = {1e39, 1, 1};
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("nodes[0]"), HasSubstr("1e+39 m"), HasSubstr("float32")));
}

TEST(SingularTransforms, FlattenedToAPlaneWithItsNormal) {
    GltfWriter writer;
    // The apex of the tetrahedron is above its base, so all four faces keep area when y is dropped.
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 0, 1, 0.25f, 1, 0.25f});
    writer.primitive()["indices"] =
        writer.add_accessor<std::uint8_t>({0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}, "SCALAR");
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>({-1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0}, "VEC3");
    writer.json["nodes"][0]["scale"] = {2, 0, 1};
    writer.json["nodes"][0]["translation"] = {0, 5, 0};
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.instances.size(), 1u);
    const Mesh& mesh = result.scene.meshes.at(result.scene.instances[0].mesh);
    ASSERT_EQ(mesh.triangles.size(), 4u);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        EXPECT_EQ(mesh.normals[i], glm::vec3(0, i < 3 ? -1 : 1, 0));  // the first face is the bottom
        EXPECT_EQ(mesh.positions[i].y, 0.0f);
    }
    EXPECT_EQ(mesh.positions.at(1), glm::vec3(2, 0, 0));
    EXPECT_EQ(placed(result, {0, 0, 0}).y, 5.0);
    EXPECT_THAT(result.added, ::testing::Contains("flattened by the transform, flat normals made: nodes[0]"));
}

TEST(SingularTransforms, EdgeOnTrianglesAreDropped) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["scale"] = {0, 1, 1};
    const ImportResult result = writer.import();
    EXPECT_TRUE(result.scene.instances.empty());
    EXPECT_THAT(result.dropped, ::testing::Contains(HasSubstr("nodes[0]: 1 triangle left without area")));
}

TEST(SingularTransforms, RotatedProductIsRecognized) {
    GltfWriter writer;
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0});
    writer.json["nodes"][0]["rotation"] = {0.1, 0.2, 0.3, 0.9};
    writer.add("nodes", {{"children", {0}}, {"scale", {1, 1, 0}}});
    writer.add("nodes", {{"children", {1}}, {"rotation", {0.5, -0.3, 0.2, 0.7}}});
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.instances.size(), 1u);
    const Mesh& mesh = result.scene.meshes.at(result.scene.instances[0].mesh);
    ASSERT_EQ(mesh.triangles.size(), 3u);
    for (const glm::vec3 normal : mesh.normals) {
        EXPECT_NEAR(std::abs(glm::dot(normal, mesh.normals[0])), 1.0f, kFloatTolerance);
    }
}

TEST(SingularTransforms, RoundingDoesNotKeepEdgeOnTriangles) {
    GltfWriter writer;
    // The first triangle lies flat; the second stands on the plane into which the scale flattens.
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 1, 0});
    const double half = std::sqrt(0.5);
    writer.json["nodes"][0]["rotation"] = {half, 0, 0,
                                           half};  // 90 degrees about +X: y becomes z up to rounding
    writer.add("nodes", {{"children", {0}}, {"scale", {1, 1, 0}}});
    writer.add("nodes", {{"children", {1}}, {"rotation", {0.5, -0.3, 0.2, 0.7}}});
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.instances.size(), 1u);
    const Mesh& mesh = result.scene.meshes.at(result.scene.instances[0].mesh);
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_THAT(result.dropped, ::testing::Contains(HasSubstr("1 triangle left without area")));
}

TEST(SingularTransforms, UniformlyTinyScaleIsNotSingular) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["scale"] = {1e-120, 1e-120, 1e-120};
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.meshes.size(), 1u);
    EXPECT_EQ(placed(result, {1, 0, 0}).x, 1e-120);
}

TEST(Hierarchy, CycleIsFound) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add("nodes", {{"children", {2}}});
    writer.add("nodes", {{"children", {1}}});
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("nodes[1]"), HasSubstr("cycle"), HasSubstr("must form trees")));
}

TEST(Hierarchy, NodeUnderItselfIsFound) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["nodes"][0]["children"] = Json::array({0});
    EXPECT_THAT(import_error(writer), HasSubstr("cycle"));
}

TEST(Hierarchy, TwoParentsAreFound) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add("nodes", {{"children", {0}}});
    writer.add("nodes", {{"children", {0}}});
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("nodes[2].children[0]"), HasSubstr("nodes[0] is already a child of nodes[1]"),
                      HasSubstr("one parent")));
}

TEST(Hierarchy, DeepChainDoesNotOverflowTheStack) {
    GltfWriter writer;
    writer.add_triangle();
    constexpr int kDepth = 100'000;
    for (int i = 0; i < kDepth; ++i) {
        writer.add("nodes", {{"children", Json::array({i})}, {"translation", {1, 0, 0}}});
    }
    EXPECT_EQ(placed(writer.import(), {0, 0, 0}).x, kDepth);
}

TEST(Scenes, TheOneNamedIsDrawn) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add_triangle();
    writer.json["nodes"][0]["name"] = "first";
    writer.json["nodes"][1]["name"] = "second";
    writer.json["scenes"] = Json::array({{{"nodes", {0}}}, {{"nodes", {1}}, {"name", "chosen"}}});
    EXPECT_EQ(writer.import().scene.instances.at(0).name, "first");
    writer.json["scene"] = 1;
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.instances.size(), 1u);
    EXPECT_EQ(result.scene.instances[0].name, "second");
    EXPECT_EQ(result.scene.name, "chosen");
}

TEST(Scenes, WithoutAnyAllRootsAreDrawn) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add_triangle();
    writer.add("nodes", {{"children", {1}}});
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.instances.size(), 2u);
    EXPECT_EQ(result.scene.name, "scene");
}

TEST(Scenes, OnlyRootsOnceEach) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add("nodes", {{"children", {0}}});
    writer.json["scenes"] = Json::array({{{"nodes", {1, 0}}}});
    EXPECT_THAT(import_error(writer),
                AllOf(HasSubstr("scenes[0].nodes[1]"), HasSubstr("nodes[0] is a child of nodes[1]")));
    writer.json["scenes"][0]["nodes"] = {1, 1};
    EXPECT_THAT(import_error(writer), HasSubstr("scenes[0].nodes[1]: nodes[1] is listed twice"));
}

TEST(Instances, ShareTheirMesh) {
    GltfWriter writer;
    writer.add_triangle();
    writer.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 1}}});
    const ImportResult result = writer.import();
    EXPECT_EQ(result.scene.meshes.size(), 1u);
    ASSERT_EQ(result.scene.instances.size(), 2u);
    EXPECT_EQ(placed(result, {0, 0, 0}, 1).z, 1.0);
}

TEST(Instances, SkinsAreListed) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["skins"] = Json::array({{{"joints", {0}}}});
    writer.json["nodes"][0]["skin"] = 0;
    EXPECT_THAT(writer.import().ignored,
                ::testing::Contains("skins are not applied, meshes are drawn unposed: nodes[0]"));
}

}  // namespace
}  // namespace utsuri::test
