// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Roundings of a few float64 operations on numbers near 1.
constexpr double kTransformTolerance = 1e-14;

/// The box of the scene is kept in float32: relative error 6e-8, of a distance below 5.
constexpr double kBoundsTolerance = 1e-6;

class CameraFile : public GltfWriter {
  public:
    CameraFile() {
        json["cameras"] =
            Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}});
        add("nodes", {{"camera", 0}});
    }
    Json& node() { return json["nodes"][0]; }
    Camera imported() { return import().scene.cameras.at(0); }
};

void expect_right_handed(const Camera& camera) {
    expect_near(glm::cross(camera.right, camera.up), -camera.forward, kTransformTolerance);
    EXPECT_NEAR(glm::length(camera.right), 1.0, kTransformTolerance);
    EXPECT_NEAR(glm::length(camera.up), 1.0, kTransformTolerance);
    EXPECT_NEAR(glm::dot(camera.right, camera.up), 0.0, kTransformTolerance);
}

TEST(Cameras, LooksAlongMinusZ) {
    CameraFile file;
    file.node()["translation"] = {1, 2, 3};
    const Camera camera = file.imported();
    EXPECT_EQ(camera.name, "cameras[0]");
    EXPECT_EQ(camera.vertical_fov, 0.8);
    expect_near(camera.position, {1, 2, 3}, 0.0);
    expect_near(camera.forward, {0, 0, -1}, 0.0);
    expect_near(camera.right, {1, 0, 0}, 0.0);
    expect_near(camera.up, {0, 1, 0}, 0.0);
}

TEST(Cameras, ScaleIsDroppedAndShearStraightened) {
    CameraFile file;
    file.node()["matrix"] = {2, 0, 0, 0, 0, 3, 1, 0, 0, 0, 4, 0, 0, 0, 0, 1};
    const Camera camera = file.imported();
    expect_right_handed(camera);
    expect_near(camera.forward, {0, 0, -1}, 0.0);
    expect_near(camera.up, {0, 1, 0}, kTransformTolerance);
}

TEST(Cameras, MirroredNodeStaysRightHanded) {
    CameraFile file;
    file.node()["scale"] = {-1, 1, 1};
    const Camera camera = file.imported();
    expect_right_handed(camera);
    expect_near(camera.right, {1, 0, 0}, kTransformTolerance);
}

TEST(Cameras, RotationOfTheParentCounts) {
    CameraFile file;
    const double half = std::sqrt(0.5);
    file.add("nodes", {{"children", {0}}, {"rotation", {0, half, 0, half}}});  // 90 degrees about +Y
    const Camera camera = file.imported();
    expect_near(camera.forward, {-1, 0, 0}, kTransformTolerance);
    expect_near(camera.right, {0, 0, -1}, kTransformTolerance);
}

TEST(Cameras, CollapsedNodeHasNoDirection) {
    CameraFile file;
    file.node()["scale"] = {1, 0, 1};
    const ImportResult result = file.import();
    EXPECT_THAT(result.ignored, Contains("cameras whose node has no direction left are not used: nodes[0]"));
    EXPECT_EQ(result.scene.cameras.at(0).name, "default");
}

TEST(Cameras, OrthographicIsListed) {
    CameraFile file;
    file.json["cameras"][0] = {{"type", "orthographic"},
                               {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}};
    const ImportResult result = file.import();
    EXPECT_THAT(result.ignored, ElementsAre("orthographic cameras are not used: cameras[0]"));
    EXPECT_EQ(result.scene.cameras.at(0).name, "default");
}

TEST(Cameras, NearPlanesThatWouldCutAreNoted) {
    CameraFile file;
    file.add_triangle();  // of edge 1, about a corner at the origin
    file.json["cameras"][0]["perspective"]["znear"] = 2;
    const auto notes_from = [&](double x, double z) {
        file.node()["translation"] = {x, 0, z};
        return file.import().ignored;
    };
    const auto noted = Contains("near planes are not used: what lies before znear is drawn: cameras[0]");
    EXPECT_THAT(notes_from(0.0, 1.9), noted);
    EXPECT_THAT(notes_from(0.0, 2.1), Not(noted)) << "behind the plane";
    EXPECT_THAT(notes_from(0.0, -0.1), Not(noted)) << "behind the eye";
    // The view reaches 1.9 tan(0.4) = 0.803 to the side; the triangle from 0 to 1.
    EXPECT_THAT(notes_from(1.75, 1.9), noted);
    EXPECT_THAT(notes_from(1.85, 1.9), Not(noted)) << "beside the picture";
}

TEST(Cameras, WrongValuesAreNamed) {
    CameraFile file;
    file.json["cameras"][0]["perspective"]["yfov"] = 0;
    EXPECT_THAT(import_error(file), HasSubstr("cameras[0].perspective.yfov: is 0; must be a number in (0"));
    file.json["cameras"][0]["perspective"]["yfov"] = 3.2;
    EXPECT_THAT(import_error(file), HasSubstr("cameras[0].perspective.yfov: is 3.2; must be less than pi"));
    file.json["cameras"][0]["perspective"].erase("yfov");
    EXPECT_THAT(import_error(file), HasSubstr("cameras[0].perspective.yfov: missing"));
    file.json["cameras"][0].erase("perspective");
    EXPECT_THAT(import_error(file), HasSubstr("cameras[0].perspective: missing"));
}

TEST(DefaultCamera, FramesTheWholeScene) {
    GltfWriter writer;
    writer.add_mesh({-1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 1, 0, 1, 0, 1, 1});
    writer.json["nodes"][0]["translation"] = {1e6, 0, -50};
    writer.json["nodes"][0]["scale"] = {10, -20, 30};
    const ImportResult result = writer.import();
    ASSERT_EQ(result.scene.cameras.size(), 1u);
    const Camera& camera = result.scene.cameras[0];
    EXPECT_EQ(camera.name, "default");
    EXPECT_EQ(camera.vertical_fov, std::numbers::pi / 4.0);
    expect_right_handed(camera);
    EXPECT_GT(camera.position.x, 1e6);
    EXPECT_GT(camera.position.y, 0.0);
    const double edge = std::tan(0.5 * camera.vertical_fov);
    double highest = 0.0;
    for (const glm::vec3 position : result.scene.meshes.at(0).positions) {
        const glm::dvec4 world = result.scene.instances.at(0).world_from_object * glm::dvec4(position, 1.0f);
        const glm::dvec3 seen = glm::dvec3(world) - camera.position;
        const double depth = glm::dot(seen, camera.forward);
        ASSERT_GT(depth, 0.0);
        EXPECT_LT(std::abs(glm::dot(seen, camera.up)) / depth, edge);
        EXPECT_LT(std::abs(glm::dot(seen, camera.right)) / depth, edge);
        highest = std::max(highest, glm::length(seen - depth * camera.forward) / depth);
    }
    EXPECT_GT(highest, 0.5 * edge);  // and not from far away: the scene fills half of the picture
    EXPECT_THAT(result.added, Contains(HasSubstr("no camera in the file")));
}

TEST(DefaultCamera, DistanceFromTheSphereAroundTheBox) {
    GltfWriter writer;
    writer.add_mesh({-1, -1, -1, 1, 1, 1, 1, -1, 1});
    const Camera camera = writer.import().scene.cameras.at(0);
    EXPECT_NEAR(glm::length(camera.position), std::sqrt(3.0) / std::sin(std::numbers::pi / 8.0),
                kBoundsTolerance);
}

}  // namespace
}  // namespace utsuri::test
