// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_constants.h"
#include "renderers/device_scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Triangles that one pipeline draws: no pixel pays for a feature that its surface does not have.
struct DrawBatch {
    SurfaceFeatures features;
    std::uint32_t first;  ///< in DrawList::triangles
    std::uint32_t count;
};

/// The triangles of a scene that reflect nothing like a mirror, grouped by what their surfaces need, in
/// device order within a group. ReflectorDrawer draws the others.
struct DrawList {
    std::vector<std::uint32_t> triangles;
    std::vector<DrawBatch> batches;
};

DrawList plan_draws(const SceneData& scene);

}  // namespace utsuri
