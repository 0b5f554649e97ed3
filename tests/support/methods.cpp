// SPDX-License-Identifier: Apache-2.0
#include "support/methods.h"

#include "renderers/methods/method.h"

#include <glm/geometric.hpp>

namespace utsuri::test {
namespace {

Texture checker() {
    Texture texture;
    texture.width = 4;
    texture.height = 4;
    for (std::uint32_t i = 0; i < 16; ++i) {
        const auto value = static_cast<std::uint8_t>((i + i / 4) % 2 == 0 ? 230 : 60);
        texture.rgba.insert(texture.rgba.end(), {value, 180, value, 255});
    }
    return texture;
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const DrawnMethod& method) {
    return stream << "kind of map " << static_cast<int>(method.kind)
                  << (method.draws_mirrored_views ? " with mirrored views" : "");
}

std::vector<DrawnMethod> drawn_methods() {
    std::vector<DrawnMethod> methods(std::begin(kMapKinds), std::end(kMapKinds));
    for (const MapKind kind : {MapKind::proxy, MapKind::hybrid})
        methods.emplace_back(kind, true);
    return methods;
}

KeptLight kept_light(Device& device, const SceneData& data, const GpuScene& scene,
                     const LightSettings& settings) {
    return {device, data, scene, light_methods().front(), settings};
}

RasterRenderer make_raster(Device& device, const SceneData& data, const GpuScene& scene, KeptLight& light,
                           const Camera& camera, const DrawnMethod& method, const RenderSettings& settings,
                           const MapSettings& maps) {
    return {{device, data, scene, light_methods().front(), light, camera}, method, settings, maps};
}

const ReflectorDrawer* reflectors_of(const RasterRenderer& renderer) {
    return dynamic_cast<const MappedView&>(renderer.view()).reflectors();
}

DrawnScene::DrawnScene(Device& device, const Scene& scene)
    : device_(device),
      data_(prepare_scene_data(scene)),
      gpu_scene_(device, data_),
      light_(kept_light(device, data_, gpu_scene_, evenly_kept(1.0 / 60.0, 4, 0))) {}

std::unique_ptr<Renderer> DrawnScene::renderer(const DrawnMethod& method, const Camera& camera,
                                               const RenderSettings& settings, const MapSettings& maps) {
    return std::make_unique<RasterRenderer>(
        RendererInput{device_, data_, gpu_scene_, light_methods().front(), light_, camera}, method, settings,
        maps);
}

Traced DrawnScene::render(const DrawnMethod& method, const Camera& camera, const RenderSettings& settings,
                          const MapSettings& maps, std::uint32_t samples) {
    const std::unique_ptr<Renderer> made = renderer(method, camera, settings, maps);
    Film film(device_, settings.width, settings.height, "test film");
    Progress progress;
    made->prepare(progress);
    made->add_samples(film, samples, progress);
    return {film.resolve(), made->statistics()};
}

Traced render_with_maps(Device& device, const Scene& scene, const Camera& camera,
                        const RenderSettings& settings, const DrawnMethod& method, const MapSettings& maps,
                        std::uint32_t samples) {
    return DrawnScene(device, scene).render(method, camera, settings, maps, samples);
}

Scene everything_scene() {
    Scene scene;
    scene.textures.push_back(checker());
    Material walls = lambert(glm::vec3(0.7f, 0.6f, 0.5f));
    walls.base_colour_texture.texture = 0;
    add(scene, room(glm::vec3(-2, 0, -2.5f), glm::vec3(2, 3, 2.5f)), walls);
    add(scene, quad(glm::vec3(-0.5f, 2.9f, -0.5f), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)),
        emitter(glm::vec3(50)));
    add(scene, icosphere(glm::vec3(-0.6f, 0.5f, -0.5f), 0.5f, 2), mirror());
    add(scene, icosphere(glm::vec3(0.9f, 0.4f, 0.2f), 0.4f, 1),
        glossy_metal(0.4f, glm::vec3(0.9f, 0.7f, 0.4f)));
    add(scene, quad(glm::vec3(-1, 0.5f, -2.45f), glm::vec3(2, 0, 0), glm::vec3(0, 1.5f, 0)), mirror());
    Light point;
    point.position = glm::dvec3(1.5, 2.0, 1.5);
    point.intensity = glm::vec3(8.0f);
    Light spot = point;
    spot.type = LightType::spot;
    spot.position = glm::dvec3(-1.5, 2.5, 1.0);
    spot.direction = glm::normalize(glm::dvec3(1, -2, -1));
    Light sun = point;
    sun.type = LightType::directional;
    sun.direction = glm::normalize(glm::dvec3(0.3, -1.0, 0.2));
    sun.intensity = glm::vec3(3.0f);
    scene.lights = {point, spot, sun};
    return scene;
}

Camera everything_camera() {
    return look_at(glm::dvec3(0.7, 1.6, 2.2), glm::dvec3(-0.2, 0.9, -1.0), 1.0);
}

}  // namespace utsuri::test
