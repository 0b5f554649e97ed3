// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/planar_renderer.h"

#include "renderers/reflection_map/map_preparation.h"

#include "interop/specialization.h"

#include <algorithm>
#include <chrono>

namespace utsuri {
namespace {

Specialization with_proxy_maps(Specialization specialization) {
    specialization[interop::SPEC_MAP_KIND] = whole_map_kind(MapKind::proxy);
    return specialization;
}

/// Instances that take maps: those with a triangle that is reflective and in no plane.
std::vector<std::uint32_t> curved_instances(const SceneData& data, const PlaneMirrors& mirrors) {
    std::vector<std::uint32_t> instances;
    for (const std::uint32_t triangle : mirrors.others)
        instances.push_back(data.triangle_infos[triangle].instance);
    std::sort(instances.begin(), instances.end());
    instances.erase(std::unique(instances.begin(), instances.end()), instances.end());
    return instances;
}

}  // namespace

PlanarRenderer::PlanarRenderer(Device& device, const SceneData& data, const GpuScene& scene,
                               FilledLight& light, const Camera& camera, const RenderSettings& settings,
                               const MapSettings& map_settings)
    : data_(data),
      scene_(scene),
      filled_light_(light),
      settings_(settings),
      mirrors_(find_plane_mirrors(data)),
      maps_(device, data, MapKind::proxy, map_settings, {camera, settings.width, settings.height},
            curved_instances(data, mirrors_)),
      rough_maps_(device, data, rough_map_settings(MapKind::proxy, map_settings)),
      light_cache_(device, data, light.settings),
      capture_(device, scene, light_cache_, maps_, settings, map_settings),
      drawer_(device, data, mirrors_, maps_.reflectors(), maps_.faces(),
              with_proxy_maps(with_proxies(maps_.specialise(scene.specialization()), maps_, rough_maps_)),
              drawing_bindings(), settings.width, settings.height) {
    look_from(camera);
}

Bindings PlanarRenderer::drawing_bindings() const {
    Bindings bindings = scene_.bindings();
    bindings.merge(light_cache_.bindings());
    bindings.merge(maps_.bindings());
    bindings.merge(rough_maps_.bindings());
    return bindings;
}

void PlanarRenderer::prepare(Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    drawer_.warm_up();
    statistics_.compile_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    prepare_light_and_surroundings(scene_, filled_light_, light_cache_, {&rough_maps_, nullptr, nullptr},
                                   settings_, statistics_, progress);
    capture_.prepare(
        camera_, [&](const glm::vec2& jitter) { drawer_.draw_frame(images_, settings_.seed, jitter); },
        statistics_, progress);
}

void PlanarRenderer::look_from(const Camera& camera) {
    camera_ = camera;
    Camera in_scene = camera;
    in_scene.position -= data_.origin;
    images_ = plan_mirror_images(mirrors_.mirrors, in_scene, settings_.width, settings_.height,
                                 static_cast<double>(drawer_.near_plane()), settings_.specular_depth);
}

bool PlanarRenderer::draw_frame() {
    const Progress silent;
    do {
        drawer_.draw_frame(images_, settings_.seed, {0.5f, 0.5f});
    } while (capture_.complete(statistics_, silent));
    return true;
}

FrameCounts PlanarRenderer::render(Film& film, std::uint32_t count, Progress& progress) {
    return drawer_.add_samples(film, images_, settings_.seed, count, progress,
                               [&] { return capture_.complete(statistics_, progress); });
}

}  // namespace utsuri
