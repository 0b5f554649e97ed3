// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

/// Radiance of the parts of textured lights, which are summed piece by piece: interop/light_pieces.h.
struct LightPieces {
    std::vector<std::uint32_t>
        first;  ///< of each light, into `radiance`; NONE where its radiance is the same all over
    std::vector<glm::vec3> radiance;  ///< cd/m2, means over pieces
};

LightPieces find_light_pieces(const SceneData& data);

}  // namespace utsuri
