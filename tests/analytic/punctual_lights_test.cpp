// SPDX-License-Identifier: Apache-2.0
// Point, spot and directional lights above a Lambert plane: L = albedo / pi * E, with E from
// KHR_lights_punctual.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlbedo = 0.5;

class PunctualLights : public DeviceTest {
  protected:
    /// Irradiance of the ground at (x, 0, 0).
    static Estimate irradiance(const Light& light, double x) {
        Scene scene;
        add(scene, ground(10.0f), lambert(glm::vec3(static_cast<float>(kAlbedo))));
        scene.lights.push_back(light);
        Estimate estimate = Observer(device(), scene).look({x + 1.0, 3.0, 2.0}, {x, 0.0, 0.0}, 2);
        estimate.mean *= kPi / kAlbedo;
        estimate.standard_error *= kPi / kAlbedo;
        return estimate;
    }
};

Light point_light() {
    Light light;
    light.position = {0.0, 1.0, 0.0};
    return light;
}

Light spot_light() {
    Light light = point_light();
    light.type = LightType::spot;
    light.direction = {0.0, -1.0, 0.0};
    light.inner_cone_angle = 0.3;
    light.outer_cone_angle = 0.6;
    return light;
}

// E = I h / (h^2 + x^2)^1.5 with I = h = 1: 1, 2^-1.5, 10^-1.5.
TEST_F(PunctualLights, PointLightFallsOffWithDistanceAndCosine) {
    expect_radiance(irradiance(point_light(), 0.0), 1.0);
    expect_radiance(irradiance(point_light(), 1.0), 0.353553391);
    expect_radiance(irradiance(point_light(), 3.0), 0.0316227766);
}

TEST_F(PunctualLights, ColoursAreIndependent) {
    Light light = point_light();
    light.intensity = {1.0f, 0.0f, 4.0f};
    expect_radiance(irradiance(light, 1.0), 0.353553391 * glm::dvec3(1.0, 0.0, 4.0));
}

// E = E0 cos(60 degrees), anywhere.
TEST_F(PunctualLights, DirectionalLightFollowsTheCosine) {
    Light light;
    light.type = LightType::directional;
    light.direction = {std::sin(kPi / 3.0), -std::cos(kPi / 3.0), 0.0};
    light.intensity = glm::vec3(3.0f);
    expect_radiance(irradiance(light, 0.0), 1.5);
    expect_radiance(irradiance(light, 3.0), 1.5);
}

TEST_F(PunctualLights, DirectionalLightFromBelowIsDark) {
    Light light;
    light.type = LightType::directional;
    light.direction = {0.0, 1.0, 0.0};
    expect_radiance(irradiance(light, 0.0), 0.0);
}

// Straight down from height 1 the angle off the axis is atan x, so E = cos^3 times the cone's factor
// ((cos - cos outer) / (cos inner - cos outer))^2, clamped to [0, 1].
TEST_F(PunctualLights, SpotLightFallsOffBetweenItsCones) {
    const auto expected = [](double angle) {
        const double ratio = (std::cos(angle) - std::cos(0.6)) / (std::cos(0.3) - std::cos(0.6));
        const double cone = std::clamp(ratio, 0.0, 1.0);
        return std::pow(std::cos(angle), 3.0) * cone * cone;
    };
    expect_radiance(irradiance(spot_light(), std::tan(0.2)), std::pow(std::cos(0.2), 3.0));
    // The cone's slope turns the width of a close-up, about 4e-4 of the distance, into as much spread.
    expect_radiance(irradiance(spot_light(), std::tan(0.45)), expected(0.45));
    expect_radiance(irradiance(spot_light(), std::tan(0.55)), expected(0.55));
    expect_radiance(irradiance(spot_light(), std::tan(0.65)), 0.0);
}

// The recommended window: max(1 - (d / range)^4, 0) / d^2.
TEST_F(PunctualLights, RangeCutsOff) {
    Light light = point_light();
    light.range = 2.0;
    expect_radiance(irradiance(light, 0.0), 15.0 / 16.0);
    expect_radiance(irradiance(light, 1.0), 0.353553391 * 0.75);
    expect_radiance(irradiance(light, 2.0), 0.0);
}

}  // namespace
}  // namespace utsuri::test
