// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/reflection/reflectors/map_kind.h"

#include "interop/reflection.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// Probes of one reflector, at most.
inline constexpr std::uint32_t kMostProbes = 64;

/// A point that maps of a reflector are captured from.
struct Probe {
    std::uint32_t reflector;   ///< its place among those that probes are placed for
    glm::dvec3 capture_point;  ///< scene space
};

struct ProbeSettings {
    std::uint32_t most = 1;  ///< of one reflector, [1, kMostProbes]
    /// World space: the first of each reflector, find_capture_point() if not set.
    std::optional<glm::dvec3> first = std::nullopt;
};

/// The probes of every reflector, in the order of the reflectors: the first, and as long as there may be more
/// the one of a few dozen places on its surface that lowers the mean predicted error of what the reflector
/// can show most, if that is by a noticeable share. Errors are predicted for rays that leave the surface all
/// over it and in all directions: by their parallax (docs/architecture.md, "Prediction"), and for maps with
/// distances only where a probe does not see what the ray meets.
/// @param reflectors instances, ascending
std::vector<Probe> place_probes(const SceneData& scene, const std::vector<std::uint32_t>& reflectors,
                                MapKind kind, const ProbeSettings& settings);

/// Which of the probes belong to each of the reflectors.
std::vector<interop::ProbeRange> probe_ranges(const std::vector<Probe>& probes, std::size_t reflectors);

}  // namespace utsuri
