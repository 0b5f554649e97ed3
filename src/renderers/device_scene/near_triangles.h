// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/device_scene/triangle_frame.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Other triangles that may come as near as `gap` to a triangle and its plane, found by the scene's BVH.
/// @param gap metres
std::vector<std::uint32_t> triangles_near_plane(const SceneData& scene, std::uint32_t triangle,
                                                const TriangleFrame& frame, double gap);

}  // namespace utsuri
