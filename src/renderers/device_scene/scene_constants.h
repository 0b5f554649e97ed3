// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "gpu/kernel.h"

namespace utsuri {

/// Values of the kernels' constants that follow from a scene.
Specialization scene_constants(const SceneData& data);

/// Those of them that decide where triangles are drawn: passes over the same triangles must agree on them.
Specialization depth_constants(const Specialization& specialization);

/// The same for what shades only surfaces that take no more than these features.
Specialization with_features(Specialization specialization, const SurfaceFeatures& features);

}  // namespace utsuri
