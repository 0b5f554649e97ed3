// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/scene_data.h"

#include "interop/rough_map.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// The maps of every instance with a rough lobe: which roughness, which size, and where their texels are.
struct RoughMapPlan {
    std::vector<interop::RoughMapInfo>
        infos;  ///< of each instance of the scene; places and boxes are not set
    std::vector<interop::RoughLevel> levels;
    std::vector<std::uint32_t>
        source_sizes;  ///< texels along an edge of what is captured for each instance, or 0
    std::uint64_t texels = 0;

    [[nodiscard]] std::uint32_t largest_source() const;
    /// Perceptual roughness of a level of an instance, its first being 0.
    [[nodiscard]] float roughness(std::uint32_t instance, std::uint32_t level) const;
};

/// @param most_size largest size of anything that is captured, >= 1
RoughMapPlan plan_rough_maps(const SceneData& data, std::uint32_t most_size);

/// Device memory of the maps of a scene while they are captured, in bytes.
std::uint64_t rough_map_bytes(const SceneData& data, std::uint32_t most_size);

}  // namespace utsuri
