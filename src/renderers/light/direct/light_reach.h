// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_change.h"

#include "interop/light_mesh.h"

#include <vector>

namespace utsuri {

/// Bounds of all lights, at most this many of lights somewhere and as many of infinitely far ones: what a
/// point is tested against has to cost less than a few shadow rays.
inline constexpr std::size_t kMostLightBounds = 32;
std::vector<interop::LightBounds> bounds_of_lights(const SceneData& data);

/// Where a change can have put surfaces into another light, or light out of their way.
struct ChangedSpace {
    std::vector<std::uint32_t> triangles;  ///< that it touched; ascending
    /// They lie in these, where they were and where they are; at most kMostChangedBoxes.
    std::vector<interop::ChangedBox> boxes;
};
inline constexpr std::size_t kMostChangedBoxes = 16;

/// @param data after the change
ChangedSpace changed_space(const SceneData& data, const SceneChange& change);

}  // namespace utsuri
