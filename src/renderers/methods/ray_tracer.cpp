// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/ray_tracer.h"

#include "renderers/film/frame_camera.h"

#include "kernels/trace_direct.h"

#include <algorithm>

namespace utsuri {

RayTracer::RayTracer(Device& device, const SceneData& data, const GpuScene& scene, const Camera& camera,
                     const RenderSettings& settings)
    : device_(device),
      data_(data),
      settings_(settings),
      frame_{{}, settings.seed, std::min(settings.specular_depth, scene.specular_depth()), interop::NONE},
      kernel_(device, "trace_direct", kernels::trace_direct, scene.specialization(), scene.bindings()) {
    look_from(camera);
}

void RayTracer::follow(const SceneChange&, Progress&) {
    restart_statistics();
}

void RayTracer::look_from(const Camera& camera) {
    frame_.camera = make_camera_info(camera, data_.origin, settings_.width, settings_.height);
}

void RayTracer::prepare(Progress&) {
    Film scratch(device_, interop::TILE_SIZE, interop::TILE_SIZE, "warm-up film");
    statistics_.compile_seconds += kernel_.warm_up(scratch);
}

FrameCounts RayTracer::render(Film& film, std::uint32_t count, Progress& progress) {
    return kernel_.add_samples(film, frame_, count, progress);
}

}  // namespace utsuri
