// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/glossy/inverse_distance_kernel.h"

#include "gpu/budgeted_run.h"

#include "interop/bindings.h"
#include "interop/glossy_map.h"
#include "interop/specialization.h"
#include "kernels/measure_inverse_distances.h"

namespace utsuri {
namespace {

Specialization measure_constants(const GpuScene& scene) {
    Specialization constants = scene.specialization();
    constants[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    return constants;
}

Bindings measure_bindings(const GpuScene& scene, const Buffer& inverse_distances) {
    Bindings bindings = scene.bindings();
    bindings[interop::BINDING_MAP_INVERSE_DISTANCES] = &inverse_distances;
    return bindings;
}

}  // namespace

InverseDistanceKernel::InverseDistanceKernel(Device& device, const GpuScene& scene,
                                             const Buffer& inverse_distances)
    : device_(device),
      kernel_(device, "measure_inverse_distances", kernels::measure_inverse_distances,
              measure_constants(scene), sizeof(interop::MeasureInverseDistancesPush)),
      set_(kernel_.bind(measure_bindings(scene, inverse_distances))) {}

void InverseDistanceKernel::warm_up() {
    device_.run("compile kernels", [&](const vk::raii::CommandBuffer& commands) {
        kernel_.dispatch(commands, set_, interop::MeasureInverseDistancesPush{}, 1);
    });
}

FrameCounts InverseDistanceKernel::measure(const glm::vec3& point, std::uint32_t size,
                                           std::uint32_t excluded_instance) {
    const std::uint32_t texels = interop::GLOSSY_MAP_FACES * size * size;
    interop::MeasureInverseDistancesPush push{};
    push.capture_point = point;
    push.excluded_instance = excluded_instance;
    push.size = size;
    FrameCounts counts;
    counts.rays = texels;
    counts.gpu_seconds =
        run_in_budget(device_, "measure inverse distances", kernel_, set_, push, texels, budget_);
    return counts;
}

}  // namespace utsuri
