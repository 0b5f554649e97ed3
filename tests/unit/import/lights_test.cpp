// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Roundings of a few float64 operations on numbers near 1.
constexpr double kTransformTolerance = 1e-14;

/// A file of one node that carries one light.
class LightFile : public GltfWriter {
  public:
    explicit LightFile(const Json& light) {
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
        add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    }
    Json& node() { return json["nodes"][0]; }
    Json& light() { return json["extensions"]["KHR_lights_punctual"]["lights"][0]; }
    Light imported() { return import().scene.lights.at(0); }
};

TEST(Lights, DefaultsOfTheExtension) {
    const Light light = LightFile(Json::object({{"type", "point"}})).imported();
    EXPECT_EQ(light.type, LightType::point);
    EXPECT_EQ(light.intensity, glm::vec3(1));
    EXPECT_EQ(light.range, 0.0);
}

TEST(Lights, PointWithColourIntensityAndRange) {
    LightFile file(Json::object({{"type", "point"},
                                 {"name", "lamp"},
                                 {"color", {1, 0.5, 0.25}},
                                 {"intensity", 800},
                                 {"range", 12.5}}));
    file.node()["translation"] = {1, 2, 3};
    file.node()["scale"] = {5, 5, 5};
    const Light light = file.imported();
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.intensity, glm::vec3(800, 400, 200));
    EXPECT_EQ(light.range, 12.5);
    expect_near(light.position, {1, 2, 3}, 0.0);
}

TEST(Lights, DirectionalFollowsTheNode) {
    LightFile file(Json::object({{"type", "directional"}, {"intensity", 100000}}));
    expect_near(file.imported().direction, {0, 0, -1}, 0.0);
    const double half = std::sqrt(0.5);
    file.node()["rotation"] = {-half, 0, 0, half};  // -90 degrees about +X: -Z becomes -Y
    file.node()["scale"] = {3, 3, 3};
    const Light light = file.imported();
    EXPECT_EQ(light.type, LightType::directional);
    expect_near(light.direction, {0, -1, 0}, kTransformTolerance);
    EXPECT_EQ(light.intensity, glm::vec3(1e5f));
}

TEST(Lights, SpotConeAngles) {
    LightFile file(Json::object({{"type", "spot"}, {"spot", Json::object()}}));
    EXPECT_EQ(file.imported().inner_cone_angle, 0.0);
    EXPECT_EQ(file.imported().outer_cone_angle, std::numbers::pi / 4.0);
    file.light()["spot"] = {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}};
    EXPECT_EQ(file.imported().inner_cone_angle, 0.25);
    EXPECT_EQ(file.imported().outer_cone_angle, 0.5);
}

TEST(Lights, SpotConeAnglesAreTakenAsRounded) {
    LightFile file(Json::object({{"type", "spot"}, {"spot", {{"outerConeAngle", 1.5707963705062866}}}}));
    EXPECT_EQ(file.imported().outer_cone_angle, std::numbers::pi / 2.0);
    EXPECT_THAT(file.import().ignored, IsEmpty());
    // 0.7 and its neighbour in float32.
    for (const double inner : {0.699999988079071, 0.7000000476837158}) {
        file.light()["spot"] = {{"innerConeAngle", inner}, {"outerConeAngle", 0.699999988079071}};
        EXPECT_EQ(file.imported().inner_cone_angle, file.imported().outer_cone_angle);
        EXPECT_THAT(file.import().ignored, Contains(HasSubstr("hard edge")));
    }
}

TEST(Lights, WrongValuesAreNamed) {
    LightFile file(
        Json::object({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.6}, {"outerConeAngle", 0.5}}}}));
    const std::string place = "extensions.KHR_lights_punctual.lights[0].";
    EXPECT_THAT(import_error(file),
                HasSubstr(place + "spot.innerConeAngle: is 0.6; must be less than outerConeAngle, 0.5"));
    file.light()["spot"] = {{"outerConeAngle", 1.6}};
    EXPECT_THAT(import_error(file),
                HasSubstr(place + "spot.outerConeAngle: is 1.6; must be a number in (0, 1.57"));
    file.light()["spot"] = {{"innerConeAngle", -0.1}};
    EXPECT_THAT(import_error(file), HasSubstr(place + "spot.innerConeAngle: is -0.1"));
    file.light().erase("spot");
    EXPECT_THAT(import_error(file), HasSubstr(place + "spot: missing"));
    file.light() = {{"type", "area"}};
    EXPECT_THAT(import_error(file),
                HasSubstr(place + "type: is \"area\"; must be one of point, spot, directional"));
    file.light() = {{"type", "point"}, {"intensity", -1}};
    EXPECT_THAT(import_error(file), HasSubstr(place + "intensity: is -1"));
    file.light() = {{"type", "point"}, {"range", 0}};
    EXPECT_THAT(import_error(file), HasSubstr(place + "range: is 0; must be a number above 0"));
    file.light() = {{"type", "point"}, {"intensity", 1e30}, {"color", {1e30, 0, 0}}};
    EXPECT_THAT(import_error(file), HasSubstr(place + "intensity: is 1e+30, which times color is beyond"));
    file.light() = {{"type", "point"}};
    file.node()["extensions"]["KHR_lights_punctual"]["light"] = 1;
    EXPECT_THAT(
        import_error(file),
        HasSubstr("nodes[0].extensions.KHR_lights_punctual.light: is 1; must be an index into lights"));
}

TEST(Lights, CollapsedNodeHasNoDirection) {
    LightFile file(Json::object({{"type", "directional"}}));
    file.node()["scale"] = {1, 1, 0};
    const ImportResult result = file.import();
    EXPECT_TRUE(result.scene.lights.empty());
    EXPECT_THAT(result.ignored, Contains("lights whose node has no direction left are not used: nodes[0]"));
    file.light()["type"] = "point";
    EXPECT_EQ(file.import().scene.lights.size(), 1u);
}

TEST(Lights, MakeTheSurroundingsDark) {
    LightFile file(Json::object({{"type", "point"}}));
    file.add_triangle();
    EXPECT_EQ(file.import().scene.environment, glm::vec3(0));
}

}  // namespace
}  // namespace utsuri::test
