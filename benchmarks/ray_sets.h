// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "interop/rays.h"

#include <cstdint>
#include <string>
#include <vector>

namespace utsuri {

/// Rays as a renderer would trace them, in the order in which it would.
struct RaySets {
    std::vector<interop::RayInfo> primary;  ///< through pixel centres, in 8 x 8 tiles
    std::vector<interop::RayInfo> diffuse;  ///< cosine distributed, from the first hits
    std::vector<interop::RayInfo> shadow;   ///< to points of the lights, from the first hits
};

/// Rays of a camera's picture. First hits come from the host's float64 reference, so that no contestant helps
/// in making them.
RaySets make_ray_sets(const SceneData& data, const Camera& camera, std::uint32_t width, std::uint32_t height);

}  // namespace utsuri
