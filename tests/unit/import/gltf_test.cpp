// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

namespace utsuri::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(EmptyScenes, ImportWithCameraAndSurroundings) {
    GltfWriter writer;
    const ImportResult result = writer.import();
    EXPECT_THAT(result.scene.meshes, IsEmpty());
    EXPECT_THAT(result.scene.instances, IsEmpty());
    EXPECT_EQ(result.scene.cameras.size(), 1u);
    EXPECT_EQ(result.scene.environment, glm::vec3(1));
    EXPECT_THAT(result.added,
                ElementsAre("no triangle in the file: the scene is empty",
                            "no light in the file: lit by a uniform environment of 1 cd/m2",
                            "no camera in the file: one that frames the whole scene, named \"default\""));
}

TEST(EmptyScenes, SceneWithoutNodes) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["scenes"] = Json::array({Json::object()});
    EXPECT_THAT(writer.import().scene.instances, IsEmpty());
}

TEST(CompleteScenes, NeedNoAdditions) {
    GltfWriter writer;
    writer.add_triangle();
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    writer.json["cameras"] =
        Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
    writer.json["extensions"] = {{"KHR_lights_punctual", {{"lights", Json::array({{{"type", "point"}}})}}}};
    writer.json["nodes"][0]["camera"] = 0;
    writer.json["nodes"][0]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}};
    const ImportResult result = writer.import();
    EXPECT_THAT(result.added, IsEmpty());
    EXPECT_THAT(result.ignored, IsEmpty());
    EXPECT_THAT(result.dropped, IsEmpty());
}

TEST(Animations, AreListed) {
    GltfWriter writer;
    writer.add_triangle();
    writer.json["animations"] = Json::array({{{"channels", Json::array()}, {"samplers", Json::array()}}});
    EXPECT_THAT(writer.import().ignored,
                ElementsAre("animations are not played, the scene is drawn at rest: animations[0]"));
}

TEST(LargeMeshes, KeepEveryTriangle) {
    // A grid of 600 x 600 squares: more vertices than 16 bits count.
    constexpr std::uint32_t kSide = 601;
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), 0.0f});
            if (x + 1 == kSide || y + 1 == kSide) continue;
            const std::uint32_t v = y * kSide + x;
            indices.insert(indices.end(), {v, v + 1, v + kSide, v + 1, v + kSide + 1, v + kSide});
        }
    }
    GltfWriter writer;
    writer.add_mesh(positions);
    writer.primitive()["indices"] = writer.add_accessor(indices, "SCALAR");
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>(std::vector<float>(positions.size(), 1.0f), "VEC3");
    const ImportResult result = import_gltf(writer.write_glb());
    ASSERT_EQ(result.scene.meshes.size(), 1u);
    EXPECT_EQ(result.scene.meshes[0].triangles.size(), 2u * 600u * 600u);
    EXPECT_EQ(result.scene.meshes[0].triangles.back(),
              glm::uvec3(kSide * kSide - kSide - 1, kSide * kSide - 1, kSide * kSide - 2));
}

}  // namespace
}  // namespace utsuri::test
