// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/scene/scene_data.h"

#include "interop/light_cache.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Where light is kept: a lattice over each triangle that has a diffuse part, fine enough for `spacing`, and
/// coarser on all of them alike where the points would be more than `most_points`.
/// @param spacing as LightSettings has it
/// @returns an entry for each triangle, in device order
std::vector<interop::LightCacheTriangle> plan_light_cache(const SceneData& data, double spacing,
                                                          std::uint64_t most_points);

/// Points of a planned cache.
std::uint64_t light_cache_points(const std::vector<interop::LightCacheTriangle>& plan);

/// Points of one lattice.
std::uint64_t lattice_points(const interop::LightCacheTriangle& lattice);

/// Whether points lie at the same places of their triangles, whatever their numbers.
bool same_lattice(const interop::LightCacheTriangle& a, const interop::LightCacheTriangle& b);

}  // namespace utsuri
