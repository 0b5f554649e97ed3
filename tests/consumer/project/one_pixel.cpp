// SPDX-License-Identifier: Apache-2.0
// Renders one pixel through the installed library and compares it with its closed form: a Lambert surface of
// albedo a under a directional light of E lux that arrives at angle t from the normal has the luminance a /
// pi * E * cos t.

#include "base/error.h"
#include "base/version.h"

#include "session/session.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

constexpr double kAlbedo = 0.6;
constexpr double kIlluminance = 10.0;            // lux
constexpr double kAngle = std::numbers::pi / 3;  // from the normal
// Some 20 roundings of float32, each at most 6e-8 of the value.
constexpr double kTolerance = 2e-6;

utsuri::Scene lit_floor() {
    utsuri::Scene scene;
    utsuri::Mesh floor;
    floor.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    floor.normals.assign(4, {0, 1, 0});
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes.push_back(floor);

    utsuri::Material matte;
    matte.base_colour = glm::vec3(static_cast<float>(kAlbedo));
    matte.metallic = 0.0f;
    matte.specular = 0.0f;
    scene.materials.push_back(matte);
    scene.instances.push_back({"floor", 0, 0, glm::dmat4(1.0)});

    utsuri::Light sun;
    sun.type = utsuri::LightType::directional;
    sun.direction = {std::sin(kAngle), -std::cos(kAngle), 0.0};
    sun.intensity = glm::vec3(static_cast<float>(kIlluminance));
    scene.lights.push_back(sun);

    utsuri::Camera camera;
    camera.position = {0, 1, 0};
    camera.forward = {0, -1, 0};
    camera.up = {0, 0, -1};
    scene.cameras.push_back(camera);
    return scene;
}

/// Whether a picture of one pixel has the luminance of the floor with an albedo, cd/m2.
bool shows(utsuri::Picture& picture, double albedo, const char* name) {
    picture.add_samples(1);
    const double expected = albedo * std::numbers::inv_pi * kIlluminance * std::cos(kAngle);
    const double value = static_cast<double>(picture.image().pixels.front().y);
    fmt::print("utsuri {}, {}: {} cd/m2, expected {}\n", utsuri::kVersion, name, value, expected);
    return std::abs(value - expected) <= kTolerance * expected;
}

/// Whether a session refuses a scene and says what is wrong with it.
bool refuses(utsuri::Session& session, const utsuri::Scene& scene, const std::string& problem) {
    try {
        session.set_scene(scene);
    } catch (const utsuri::InputError& error) {
        fmt::print("refused: {}\n", error.what());
        return std::string(error.what()).find(problem) != std::string::npos;
    }
    return false;
}

utsuri::Picture make_pixel(utsuri::Session& session, const utsuri::Scene& scene, const char* reflection) {
    utsuri::PictureSettings settings;
    settings.method = utsuri::find_method("direct", reflection);
    settings.camera = scene.cameras.front();
    settings.render.width = 1;
    settings.render.height = 1;
    return session.make_picture(settings);
}

}  // namespace

int main() {
    utsuri::Scene scene = lit_floor();
    utsuri::Session session;
    session.set_scene(scene);
    utsuri::Picture traced = make_pixel(session, scene, "trace");
    utsuri::Picture drawn = make_pixel(session, scene, "hybrid");
    bool as_expected = shows(traced, kAlbedo, "traced") && shows(drawn, kAlbedo, "drawn");

    utsuri::Scene broken = scene;
    broken.instances.front().material = 3;
    as_expected &= refuses(session, broken, "instances[0].material: is 3");

    scene.materials.front().base_colour *= 0.5f;
    as_expected &= session.set_scene(scene).kind == utsuri::SceneUpdate::Kind::updated;
    as_expected &= shows(traced, 0.5 * kAlbedo, "traced, recoloured");
    as_expected &= shows(drawn, 0.5 * kAlbedo, "drawn, recoloured");

    scene.lights.clear();
    const utsuri::SceneUpdate update = session.set_scene(scene);
    fmt::print("rebuilt: {}\n", update.reason);
    as_expected &= update.kind == utsuri::SceneUpdate::Kind::rebuilt &&
                   update.reason == "it now has 0 lights that shine where it had 1";
    as_expected &= shows(traced, 0.0, "traced, light off") && shows(drawn, 0.0, "drawn, light off");
    return as_expected ? 0 : 1;
}
