// SPDX-License-Identifier: Apache-2.0
#include "renderers/ray_trace/ray_tracer.h"

#include "kernels/trace_direct.h"

#include <algorithm>

namespace utsuri {

RayTracer::RayTracer(Device& device, const GpuScene& scene, const interop::CameraInfo& camera,
                     const RenderSettings& settings)
    : device_(device),
      frame_{camera, settings.seed, std::min(settings.specular_depth, scene.specular_depth()), interop::NONE},
      kernel_(device, "trace_direct", kernels::trace_direct, scene.specialization(), scene.bindings()) {}

void RayTracer::prepare(Progress&) {
    Film scratch(device_, interop::TILE_SIZE, interop::TILE_SIZE, "warm-up film");
    statistics_.compile_seconds += kernel_.warm_up(scratch);
}

FrameCounts RayTracer::render(Film& film, std::uint32_t count, Progress& progress) {
    return kernel_.add_samples(film, frame_, count, progress);
}

}  // namespace utsuri
