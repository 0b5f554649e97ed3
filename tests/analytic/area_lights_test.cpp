// SPDX-License-Identifier: Apache-2.0
// Polygonal lights of radiance 1 over Lambert receivers: closed forms of Lambert's polygon sum.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlbedo = 0.8;

class AreaLights : public DeviceTest {
  protected:
    static Estimate irradiance(const Scene& scene, glm::dvec3 eye, glm::dvec3 target,
                               std::uint32_t samples = 256) {
        Estimate estimate = Observer(device(), scene).look(eye, target, samples);
        estimate.mean *= kPi / kAlbedo;
        estimate.standard_error *= kPi / kAlbedo;
        return estimate;
    }
};

Material receiver() {
    return lambert(glm::vec3(static_cast<float>(kAlbedo)));
}

/// A unit square of radiance 1 at a height over the ground.
Scene under_square(double height) {
    Scene scene;
    add(scene, ground(2.0f), receiver());
    add(scene, ceiling({0.0f, static_cast<float>(height), 0.0f}, 0.5f), emitter(glm::vec3(1.0f)));
    return scene;
}

/// A small receiver about the origin and one triangle of radiance 1.
Scene triangle_and_receiver(const glm::vec3& normal, const Mesh& light) {
    Scene scene;
    const glm::vec3 other = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = 0.1f * glm::normalize(glm::cross(other, normal));
    const glm::vec3 v = glm::cross(normal, u);
    add(scene, quad(-0.5f * (u + v), u, v), receiver());
    add(scene, light, emitter(glm::vec3(1.0f)));
    return scene;
}

TEST_F(AreaLights, UnitSquareAtHeightOne) {
    const Scene scene = under_square(1.0);
    expect_radiance(irradiance(scene, {2.0, 0.7, 0.3}, {0.0, 0.0, 0.0}), 0.752274688);
    expect_radiance(irradiance(scene, {2.0, 2.0, 1.0}, {1.0, 0.0, 0.0}), 0.265004852);
}

// Lambert's sum for the unit square straight above. The edge between the light's two triangles passes
// overhead, and that between the receiver's two underfoot.
TEST_F(AreaLights, UnitSquareNear) {
    expect_radiance(irradiance(under_square(0.1), {0.2, 0.05, 0.0}, {0.0, 0.0, 0.0}, 16384), 3.04212835);
}

// Of the light only a disc about as wide as the height counts, 3e-4 of the square, and few samples find it.
TEST_F(AreaLights, UnitSquareCloseUp) {
    constexpr double kCloseUpPower = 3e-3;
    const Estimate estimate = irradiance(under_square(0.01), {0.02, 0.005, 0.0}, {0.0, 0.0, 0.0}, 65536);
    expect_radiance(estimate, 3.14056468, kCloseUpPower);
}

// Directions uniform over the light's solid angle: what a sample brings is proportional to its cosine, whose
// square's mean is at most 4/3 of its mean's square, as over the whole hemisphere. Weighing candidates
// against each other makes it less. Lambert's sum above the middle of a square of edge 1 has one term for
// each edge.
TEST_F(AreaLights, NoiseNextToALightIsBounded) {
    constexpr std::uint32_t kSamples = 1024;
    // 256 pixels tell a variance to 2 sqrt(2 / 255), at 4.5 standard errors to 1.4 times of it.
    constexpr double kMostVariance = 1.4 / 3.0;
    for (const double height : {1.0, 0.1, 0.01, 0.001}) {
        SCOPED_TRACE(height);
        const double sine = 0.5 / std::hypot(0.5, height);
        const double expected = 4.0 * sine * std::atan(sine);
        const Estimate estimate =
            irradiance(under_square(height), {2.0 * height, 0.5 * height, 0.0}, {0.0, 0.0, 0.0}, kSamples);
        expect_radiance(estimate, expected, 2e-3);
        const double relative = estimate.standard_error.x / expected;
        EXPECT_LE(relative * relative * kSamples * kCloseUpSize * kCloseUpSize, kMostVariance);
    }
}

// What of a plane lamp is seen is as bright as it emits, though rounding puts points of it before it.
TEST_F(AreaLights, LampsDoNotLightThemselves) {
    Scene scene;
    const Mesh lamp = quad({0.31f, 1.7f, -0.2f}, {0.7f, 0.11f, 0.23f}, {-0.13f, 0.05f, 0.9f});
    add(scene, lamp, emitter(glm::vec3(1.0f)));
    scene.materials.back().base_colour = glm::vec3(1.0f);
    scene.materials.back().double_sided = true;
    const auto at = [&](std::size_t corner) { return glm::dvec3(lamp.positions[corner]); };
    const glm::dvec3 target = 0.5 * at(0) + 0.3 * at(1) + 0.2 * at(2);
    Observer observer(device(), scene);
    for (const double side : {1.0, -1.0})
        expect_radiance(observer.look(target + side * glm::dvec3(0.2, 1.0, 0.1), target, 256), 1.0);
}

TEST_F(AreaLights, UnitSquareFarAway) {
    const std::array<std::pair<double, double>, 3> cases = {
        {{10.0, 0.00996678291}, {100.0, 9.99966668e-5}, {1000.0, 9.99999667e-7}}};
    for (const auto& [height, expected] : cases) {
        SCOPED_TRACE(height);
        expect_radiance(irradiance(under_square(height), {1.0, 1.0, 0.5}, {0.0, 0.0, 0.0}, 64), expected);
    }
}

// The octant triangle seen from the origin: pi / 4 for the normal z, sqrt(3) pi / 4 along its axis.
TEST_F(AreaLights, OctantTriangle) {
    const Mesh light = triangle({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    expect_radiance(irradiance(triangle_and_receiver({0, 0, 1}, light), {-1, -1, 1}, {0, 0, 0}, 1024),
                    0.785398163);
    const glm::vec3 axis = glm::normalize(glm::vec3(1));
    expect_radiance(irradiance(triangle_and_receiver(axis, light), {-1, 1.5, 1.5}, {0, 0, 0}), 1.360349523);
}

// Partly below the receiver's horizon: what is below must not count. The unclipped sum would be negative.
TEST_F(AreaLights, HorizonCutsALight) {
    const Mesh light = triangle({2, -1, -1}, {2, 0, 2}, {2, 1, -1});
    expect_radiance(irradiance(triangle_and_receiver({0, 0, 1}, light), {-1, 0.5, 2}, {0, 0, 0}, 16384),
                    0.0698432912);
}

TEST_F(AreaLights, OneSidedLightIsDarkBehind) {
    Scene scene;
    add(scene, ground(2.0f), receiver());
    add(scene, flipped(ceiling({0, 1, 0}, 0.5f)), emitter(glm::vec3(1.0f)));
    expect_radiance(irradiance(scene, {2.0, 2.0, 1.0}, {1.0, 0.0, 0.0}, 64), 0.0);
    scene.materials.back().double_sided = true;
    expect_radiance(irradiance(scene, {2.0, 2.0, 1.0}, {1.0, 0.0, 0.0}), 0.265004852);
}

TEST_F(AreaLights, ALightIsSeenAtItsRadiance) {
    Scene scene;
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter({1.0f, 2.0f, 5.0f}));
    Observer observer(device(), scene);
    expect_radiance(observer.look({0.1, -1.0, 0.2}, {0.1, 1.0, 0.2}, 2), {1.0, 2.0, 5.0});
    expect_radiance(observer.look({0.1, 3.0, 0.2}, {0.1, 1.0, 0.2}, 2), 0.0);
}

/// The room of the Cornell box without its blocks, vertices as published by the Cornell University Program of
/// Computer Graphics: 552.8 to 556 wide, 548.8 high, 559.2 deep. The ceiling is left out, because the light
/// lies in it.
Scene empty_cornell_box() {
    Scene scene;
    add(scene, quad({552.8f, 0, 0}, {-552.8f, 0, 0}, {0, 0, 559.2f}), receiver());
    add(scene, quad({549.6f, 0, 559.2f}, {-549.6f, 0, 0}, {0, 548.8f, 0}), receiver());
    add(scene, quad({343, 548.8f, 227}, {0, 0, 105}, {-130, 0, 0}), emitter(glm::vec3(1.0f)));
    return scene;
}

TEST_F(AreaLights, EmptyCornellBox) {
    Observer observer(device(), empty_cornell_box());
    const std::array<std::pair<glm::dvec3, double>, 5> points = {{{{278, 0, 279.5}, 0.0446324747},
                                                                  {{50, 0, 50}, 0.0248946967},
                                                                  {{278, 0, 500}, 0.0333002607},
                                                                  {{278, 274.4, 559.2}, 0.0436526245},
                                                                  {{278, 100, 559.2}, 0.0215030070}}};
    for (const auto& [point, expected] : points) {
        SCOPED_TRACE(expected);
        expect_radiance(observer.look({278, 200, -300}, point, 256), expected * kAlbedo / kPi);
    }
}

}  // namespace
}  // namespace utsuri::test
