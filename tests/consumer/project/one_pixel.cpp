// SPDX-License-Identifier: Apache-2.0
// Renders one pixel through the installed library and compares it with its closed form: a Lambert surface of
// albedo a under a directional light of E lux that arrives at angle t from the normal has the luminance a /
// pi * E * cos t.
#include "renderers/methods/ray_tracer.h"
#include "renderers/scene/gpu_scene.h"

#include "base/version.h"
#include "gpu/device.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

double render_pixel(utsuri::Device& device) {
    const utsuri::Scene scene = lit_floor();
    const utsuri::SceneData data = utsuri::prepare_scene_data(scene);
    const utsuri::GpuScene gpu_scene(device, data);
    utsuri::RenderSettings settings;
    settings.width = 1;
    settings.height = 1;
    utsuri::RayTracer tracer(device, data, gpu_scene, scene.cameras.front(), settings);
    utsuri::Film film(device, 1, 1, "pixel");
    utsuri::Progress silent;
    tracer.prepare(silent);
    tracer.add_samples(film, 1, silent);
    return static_cast<double>(film.resolve().pixels.front().y);
}

}  // namespace

int main() {
    const utsuri::VulkanInstance instance;
    utsuri::Device device(instance, "");
    const double expected = kAlbedo * std::numbers::inv_pi * kIlluminance * std::cos(kAngle);
    const double value = render_pixel(device);
    fmt::print("utsuri {}: {} cd/m2, expected {}\n", utsuri::kVersion, value, expected);
    return std::abs(value - expected) <= kTolerance * expected ? 0 : 1;
}
