// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/scene_data.h"
#include "renderers/light/light.h"

#include "scene/camera.h"

namespace utsuri {

/// What a renderer is made from. Device, data and scene must outlive it: Session sees to that.
struct RendererInput {
    Device& device;
    const SceneData& data;
    const GpuScene& scene;
    const LightMethod& light;
    KeptLight& kept_light;  ///< of that method; made and filled by the first renderer that reads it
    const Camera& camera;
};

}  // namespace utsuri
