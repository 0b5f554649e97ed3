// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/direct_light.h"

#include "renderers/light/direct/light_cache.h"

#include "kernels/trace_direct.h"

namespace utsuri {
namespace {

std::unique_ptr<SurfaceLight> keep(Device& device, const SceneData& data, const GpuScene& scene,
                                   const LightSettings& settings) {
    return std::make_unique<LightCache>(device, data, scene, settings);
}

}  // namespace

LightMethod direct_light() {
    return {"direct", "with shadows, mirrors and glossy lobes followed", keep, "trace_direct",
            kernels::trace_direct};
}

}  // namespace utsuri
