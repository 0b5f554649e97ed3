// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/map_renderer.h"

#include "renderers/common/frame_camera.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/polygon_map.h"
#include "kernels/reflect_vertices.h"
#include "kernels/sphere_map.h"

#include <chrono>

namespace utsuri {
namespace {

std::span<const std::uint32_t> kernel_code(MapKind kind) {
    if (kind == MapKind::polygon) return kernels::polygon_map;
    return kernels::sphere_map;
}

Specialization with_map_size(Specialization specialization, std::uint32_t size) {
    specialization[interop::SPEC_MAP_SIZE] = size;
    return specialization;
}

}  // namespace

MapRenderer::MapRenderer(Device& device, const SceneData& data, const GpuScene& scene, const Camera& camera,
                         MapKind kind, const RenderSettings& settings, const MapSettings& map_settings)
    : device_(device),
      scene_(scene),
      camera_(camera),
      settings_(settings),
      eye_(glm::vec3(camera.position - data.origin)),
      maps_(device, data, kind, map_settings),
      vertices_(
          make_buffer<interop::ReflectorVertex>(device, maps_.reflectors().vertices, "reflector vertices")),
      vertex_reflections_(
          device,
          std::max<std::size_t>(1, maps_.reflectors().vertices.size()) * sizeof(interop::VertexReflection),
          "vertex reflections"),
      vertex_kernel_(device, "reflect_vertices", kernels::reflect_vertices, {},
                     sizeof(interop::ReflectVerticesPush)),
      vertex_bindings_(vertex_kernel_.bind({{interop::BINDING_REFLECTOR_VERTICES, &vertices_},
                                            {interop::BINDING_VERTEX_REFLECTIONS, &vertex_reflections_}})),
      // Reflections are looked up: no chain is followed.
      frame_{make_camera_info(camera, data.origin, settings.width, settings.height), settings.seed, 0,
             interop::NONE},
      kernel_(device, kind == MapKind::polygon ? "polygon_map" : "sphere_map", kernel_code(kind),
              with_map_size(scene.specialization(), map_settings.size), all_bindings()) {}

Bindings MapRenderer::all_bindings() const {
    Bindings bindings = scene_.bindings();
    bindings.merge(maps_.bindings());
    bindings[interop::BINDING_VERTEX_REFLECTIONS] = &vertex_reflections_;
    return bindings;
}

void MapRenderer::prepare(Progress& progress) {
    Film scratch(device_, interop::TILE_SIZE, interop::TILE_SIZE, "warm-up film");
    statistics_.compile_seconds += kernel_.warm_up(scratch);
    const auto start = std::chrono::steady_clock::now();
    double capture_compile_seconds = 0.0;
    accumulate(statistics_.prepare_counts,
               maps_.capture(scene_, camera_, settings_, capture_compile_seconds, progress));
    const double total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    statistics_.prepare_seconds += total - capture_compile_seconds;
    statistics_.compile_seconds += capture_compile_seconds;
}

double MapRenderer::reflect_vertices() {
    interop::ReflectVerticesPush push{};
    push.eye = eye_;
    push.right = glm::vec3(camera_.right);
    push.up = glm::vec3(camera_.up);
    push.forward = glm::vec3(camera_.forward);
    push.count = static_cast<std::uint32_t>(maps_.reflectors().vertices.size());
    if (push.count == 0) return 0.0;
    return device_.run("reflect vertices", [&](const vk::raii::CommandBuffer& commands) {
        vertex_kernel_.dispatch(commands, vertex_bindings_, push, (push.count + 63) / 64);
    });
}

FrameCounts MapRenderer::render(Film& film, std::uint32_t count, Progress& progress) {
    const double vertex_seconds = reflect_vertices();
    FrameCounts counts = kernel_.add_samples(film, frame_, count, progress);
    counts.gpu_seconds += vertex_seconds;
    return counts;
}

}  // namespace utsuri
