// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/map_renderer.h"

#include "renderers/common/frame_camera.h"

#include "interop/specialization.h"

#include <chrono>

namespace utsuri {
namespace {

Specialization with_map_size(Specialization specialization, std::uint32_t size) {
    specialization[interop::SPEC_MAP_SIZE] = size;
    return specialization;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

MapRenderer::MapRenderer(Device& device, const SceneData& data, const GpuScene& scene, FilledLight& light,
                         const Camera& camera, MapKind kind, const RenderSettings& settings,
                         const MapSettings& map_settings)
    : device_(device),
      data_(data),
      scene_(scene),
      filled_light_(light),
      camera_(camera),
      settings_(settings),
      maps_(device, data, kind, map_settings),
      light_cache_(device, data, light.settings),
      reflectors_(device, data, maps_.reflectors(), kind, maps_.faces(), map_settings.most_cut_pieces,
                  with_map_size(scene.specialization(), map_settings.size), drawing_bindings()),
      drawer_(device, data, with_map_size(scene.specialization(), map_settings.size), drawing_bindings(),
              reflectors_, settings.width, settings.height) {}

Bindings MapRenderer::drawing_bindings() const {
    Bindings bindings = scene_.bindings();
    bindings.merge(light_cache_.bindings());
    bindings.merge(maps_.bindings());
    return bindings;
}

void MapRenderer::prepare(Progress& progress) {
    auto start = std::chrono::steady_clock::now();
    drawer_.warm_up();
    reflect();
    statistics_.compile_seconds += seconds_since(start);

    light_cache_.fill(scene_, settings_.seed, filled_light_, progress);
    // Light that another renderer filled counts as if it had been filled here.
    statistics_.prepare_seconds += filled_light_.seconds;
    statistics_.compile_seconds += filled_light_.compile_seconds;
    accumulate(statistics_.prepare_counts, filled_light_.counts);

    start = std::chrono::steady_clock::now();
    double capture_compile_seconds = 0.0;
    accumulate(statistics_.prepare_counts,
               maps_.capture(scene_, light_cache_, camera_, settings_, capture_compile_seconds, progress));
    statistics_.prepare_seconds += seconds_since(start) - capture_compile_seconds;
    statistics_.compile_seconds += capture_compile_seconds;
}

void MapRenderer::look_from(const Camera& camera) {
    camera_ = camera;
    eye_moved_ = true;
}

double MapRenderer::reflect() {
    interop::ReflectVerticesPush eye{};
    eye.eye = glm::vec3(camera_.position - data_.origin);
    eye.right = glm::vec3(camera_.right);
    eye.up = glm::vec3(camera_.up);
    eye.forward = glm::vec3(camera_.forward);
    eye_moved_ = false;
    return reflectors_.look_from(eye);
}

FrameCounts MapRenderer::render(Film& film, std::uint32_t count, Progress& progress) {
    const double vertex_seconds = eye_moved_ ? reflect() : 0.0;
    const interop::CameraInfo camera =
        make_camera_info(camera_, data_.origin, settings_.width, settings_.height);
    FrameCounts counts = drawer_.add_samples(film, camera, settings_.seed, count, progress);
    counts.gpu_seconds += vertex_seconds;
    return counts;
}

}  // namespace utsuri
