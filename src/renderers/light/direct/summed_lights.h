// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/light/direct/light_pieces.h"

#include "interop/light_sums.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Lights in the order they are summed in, and their groups.
struct SummedLights {
    std::vector<interop::SummedLight> lights;
    std::uint32_t plain_triangles = 0;  ///< the first of them: triangles without a texture
    std::uint32_t triangles = 0;        ///< with those that have one
    std::vector<interop::LightGroup> groups;
};

/// Whether lights are few enough to be summed at every point.
bool sums_lights(const SceneData& data);

/// Lights that are nowhere are a group each. The others are divided, along the light tree, into lamps: lights
/// with no gap between them as wide as they are. Where there are more lamps than groups, those stay together
/// that shine least and are nearest.
SummedLights list_summed_lights(const SceneData& data, const LightPieces& pieces);

}  // namespace utsuri
