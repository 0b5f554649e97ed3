// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/reflection/reflectors/probes.h"

#include "interop/glossy_map.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// The maps of every instance with a glossy lobe: which roughness, which size, and where their texels are.
struct GlossyMapPlan {
    std::vector<interop::GlossyMapInfo> infos;  ///< of each instance of the scene
    std::vector<interop::GlossyProbe> probes;   ///< proxies are not set
    std::vector<interop::GlossyLevel> levels;
    std::vector<std::uint32_t>
        source_sizes;  ///< texels along an edge of what is captured for each instance, or 0
    std::uint64_t texels = 0;

    [[nodiscard]] std::uint32_t largest_source() const;
    /// Capture points of one instance, at least 1.
    [[nodiscard]] std::uint32_t most_probes() const;
    /// Perceptual roughness of a level of an instance, its first being 0.
    [[nodiscard]] float roughness(std::uint32_t instance, std::uint32_t level) const;
};

/// @param most_size largest size of anything that is captured, >= 1
/// @param probes of each of Requirements::glossy_instances, in their order
GlossyMapPlan plan_glossy_maps(const SceneData& data, std::uint32_t most_size,
                               const std::vector<Probe>& probes);

/// Device memory of the maps of a scene while they are captured, each instance's from one point, in bytes.
std::uint64_t glossy_map_bytes(const SceneData& data, std::uint32_t most_size);
/// The same of the distances that methods which keep some add to the maps.
std::uint64_t glossy_distance_bytes(const SceneData& data, std::uint32_t most_size);

}  // namespace utsuri
