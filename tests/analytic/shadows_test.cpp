// SPDX-License-Identifier: Apache-2.0
// Shadows with known answers, and light that must not leak.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;

class Shadows : public DeviceTest {};

Light point_light(glm::dvec3 position, float intensity = 1.0f) {
    Light light;
    light.position = position;
    light.intensity = glm::vec3(intensity);
    return light;
}

TEST_F(Shadows, ABlockerBetweenPointLightAndGroundTakesAll) {
    Scene scene;
    add(scene, ground(5.0f), lambert(glm::vec3(1.0f)));
    add(scene, ground(0.25f), lambert(glm::vec3(1.0f)));
    scene.instances.back().world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.5, 0.0));
    scene.lights.push_back(point_light({0.0, 1.0, 0.0}));
    Observer observer(device(), scene);
    // The shadow of the blocker reaches to 0.5 on the ground.
    expect_radiance(observer.look({0.3, 0.1, 2.0}, {0.3, 0.0, 0.0}, 2), 0.0);
    expect_radiance(observer.look({0.49, 0.1, 2.0}, {0.49, 0.0, 0.0}, 2), 0.0);
    const auto lit = [](double x) { return std::pow(1.0 + x * x, -1.5) / kPi; };
    expect_radiance(observer.look({0.51, 1.0, 2.0}, {0.51, 0.0, 0.0}, 2), lit(0.51));
    expect_radiance(observer.look({1.0, 1.0, 2.0}, {1.0, 0.0, 0.0}, 2), lit(1.0));
}

TEST_F(Shadows, ABlockerBeyondALightTakesNothing) {
    Scene scene;
    add(scene, ground(5.0f), lambert(glm::vec3(1.0f)));
    add(scene, ceiling({0, 1.001f, 0}, 1.0f), lambert(glm::vec3(1.0f)));
    scene.lights.push_back(point_light({0.0, 1.0, 0.0}));
    expect_radiance(Observer(device(), scene).look({1.0, 0.5, 2.0}, {1.0, 0.0, 0.0}, 2), 0.353553391 / kPi);
}

// Symmetry: a blocker over one half of the unit square of radiance 1 leaves half of 0.752274688 below its
// centre.
TEST_F(Shadows, ABlockerOverHalfALightTakesHalf) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(1.0f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    add(scene, quad({0, 0.5f, -1}, {1, 0, 0}, {0, 0, 2}), lambert(glm::vec3(0.0f)));
    Observer observer(device(), scene);
    expect_radiance(observer.look({-1.0, 0.3, 1.5}, {0.0, 0.0, 0.0}, 65536), 0.5 * 0.752274688 / kPi);
}

/// A closed box with every kind of light around it, and none inside.
Scene dark_room(const Material& walls, const glm::dmat4& placement, float thickness) {
    Scene scene;
    scene.environment = glm::vec3(1000.0f);
    add(scene, room(glm::vec3(-1.0f), glm::vec3(1.0f)), walls);
    const glm::vec3 outer(1.0f + thickness);
    if (thickness > 0.0f) add(scene, block(-outer, outer), emitter(glm::vec3(1000.0f)));
    for (Instance& instance : scene.instances)
        instance.world_from_object = placement;
    scene.lights.push_back(point_light({3.0, 0.5, 0.2}, 1e6f));
    scene.lights.push_back(point_light({-0.5, -4.0, 3.0}, 1e6f));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0.6, -0.8, 0.0};
    sun.intensity = glm::vec3(1e6f);
    scene.lights.push_back(sun);
    return scene;
}

/// No inward edge lies along an axis.
glm::dmat4 turned() {
    return glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, -0.3)), 0.7,
                       glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
}

class LightLeaks : public DeviceTest {
  protected:
    /// Every pixel of views from inside at a wall, an edge and a corner, wide and close.
    static void expect_dark(const Scene& scene, const glm::dmat4& placement, std::uint32_t samples) {
        Observer observer(device(), scene);
        const auto place = [&](const glm::dvec3& point) {
            return glm::dvec3(placement * glm::dvec4(point, 1.0));
        };
        for (const glm::dvec3 target :
             {glm::dvec3(1, 0.2, 0.1), glm::dvec3(1, 1, 0.3), glm::dvec3(-1, -1, -1)}) {
            for (const double angle : {1.5, 0.01, kCloseUpAngle}) {
                SCOPED_TRACE(testing::Message()
                             << target.x << ' ' << target.y << ' ' << target.z << ", " << angle);
                RenderSettings settings;
                settings.width = settings.height = 32;
                settings.max_depth = 32;
                const Camera camera = look_at(place({0.1, -0.05, 0.2}), place(target), angle);
                const Image image = observer.picture(camera, settings, samples);
                for (const glm::vec3& pixel : image.pixels)
                    ASSERT_EQ(pixel, glm::vec3(0.0f));
            }
        }
    }
};

TEST_F(LightLeaks, AClosedBoxIsDarkInside) {
    const glm::dmat4 upright(1.0);
    expect_dark(dark_room(lambert(glm::vec3(1.0f)), upright, 0.0f), upright, 16);
}

TEST_F(LightLeaks, ATurnedClosedBoxIsDarkInside) {
    expect_dark(dark_room(lambert(glm::vec3(1.0f)), turned(), 0.0f), turned(), 16);
}

TEST_F(LightLeaks, AGlossyClosedBoxIsDarkInside) {
    expect_dark(dark_room(glossy_metal(0.5f), turned(), 0.0f), turned(), 8);
}

TEST_F(LightLeaks, AMirrorBoxIsDarkInside) {
    expect_dark(dark_room(mirror(), turned(), 0.0f), turned(), 2);
}

// Light sources a ten-thousandth of the room's size behind the walls.
TEST_F(LightLeaks, AThinWallStopsALightBehindIt) {
    expect_dark(dark_room(lambert(glm::vec3(1.0f)), turned(), 2e-4f), turned(), 16);
}

TEST_F(LightLeaks, AClosedBallIsDarkInside) {
    Scene scene = dark_room(lambert(glm::vec3(1.0f)), glm::dmat4(1.0), 0.0f);
    scene.meshes.front() = flipped(icosphere(glm::vec3(0.0f), 1.0f, 3));
    expect_dark(scene, glm::dmat4(1.0), 16);
}

}  // namespace
}  // namespace utsuri::test
