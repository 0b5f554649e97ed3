// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_triangles.h"

#include <vector>

namespace utsuri {

/// How high a surface rises before each of its triangles: a bound on the sine of the elevation, over the
/// triangle's plane and to the side of its front, at which anything of the surface is seen from anywhere on
/// the triangle. A ray that leaves the front more steeply cannot meet the surface again, but for what rises
/// by less than rounding can: 2^-21 of the largest coordinate. Facets in one plane would rise before each
/// other by as much.
/// @param surface neighbours in the list are near each other, or it takes long; triangles that touch share
/// corners to the bit, or count as rising upright
/// @returns a sine in [0, 1] for each triangle: 0 where nothing rises, 1 where something may rise upright, or
/// where finding out would have taken more than kMostHorizonVisits
std::vector<float> self_horizons(const std::vector<Corners>& surface);

/// Pairs of a triangle and a group of others that are looked at for a surface, at most: some seconds of work,
/// enough for some 200,000 triangles of a ball.
inline constexpr std::uint64_t kMostHorizonVisits = 100'000'000;

}  // namespace utsuri
