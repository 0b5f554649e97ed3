// SPDX-License-Identifier: Apache-2.0
// Surfaces that overlap in one plane, as well as rounding lets one tell: a picture flush with its wall.
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// How far apart surfaces in one plane are, at most, metres, in scene space: some roundings of the largest
/// coordinate of the BVH's root, which kernels know too, rounded up to a power of two.
float layer_distance(const SceneData& scene);

/// Of each triangle, how many others lie on it, one on top of the other, up to MOST_LAYERS. Where triangles
/// overlap in one plane, that of the smaller instance (by the diagonal of its bounds) lies on top, of equal
/// ones that of the later instance, and within an instance that with the later vertices; from whichever side
/// they are seen.
/// @param scene with its BVH, triangle infos and instances' bounds
std::vector<std::uint32_t> count_layers(const SceneData& scene);

}  // namespace utsuri
