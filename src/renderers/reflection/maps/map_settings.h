// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/proxies/given_proxy.h"
#include "renderers/reflection/reflectors/probes.h"
#include "renderers/reflection/reflectors/reflectors.h"
#include "renderers/reflection/reflectors/tolerance.h"

#include "geometry/polyhedron.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace utsuri {

/// Size up to which maps are fitted to pixels: twice that at which a texel is as wide as a pixel of a plane
/// mirror in a picture 512 pixels and 90 degrees wide.
inline constexpr std::uint32_t kMostFittedMapSize = 1024;
/// Texels along an edge of a map, and samples of each, that can be asked for.
inline constexpr std::uint32_t kLargestMapSize = 4096;
inline constexpr std::uint32_t kMostMapSamples = 65536;

struct MapSettings {
    /// Texels along an edge of a map, [1, kLargestMapSize]; at most, if they are fitted.
    std::uint32_t size = 256;
    std::uint32_t samples = 16;  ///< per texel, [1, kMostMapSamples]
    /// World space, metres, finite; each reflector's own if not set.
    std::optional<glm::dvec3> capture_point = std::nullopt;
    std::uint32_t most_probes = 1;  ///< capture points of a reflector, [1, kMostProbes]
    /// Of polygon maps: 4 to interop::MAP_MOST_FACES planes, each of which bounds a face.
    Polyhedron polyhedron = cube();
    /// As many planes, in world space; fitted to what each reflector sees if not set.
    std::optional<GivenProxy> proxy = std::nullopt;
    PolygonRefinement refinement = {};
    /// Pieces of polygons cut along its faces that there is room for; polygons whose pieces find none are
    /// drawn whole, their faces found per pixel. >= 1; follows from the number of polygons if not set.
    std::optional<std::uint32_t> most_cut_pieces = std::nullopt;
    Tolerance tolerance = {};  ///< of MapKind::hybrid
    bool fitted = false;       ///< each probe's maps only as fine as pixels of the first view need them
    /// Where maps of this size do not fit into one buffer of the device, smaller ones share its room by what
    /// pixels of the first view need; if not set, they are refused. `hybrid` shares in any case.
    bool shares_room = true;
    bool captures_all = false;     ///< capture maps that nothing looks up yet, too, so that no frame waits
    bool predicts_errors = false;  ///< keep what Renderer::predict_errors() needs, whatever the method
};

/// @throws UsageError that names the setting that is out of its range, and the range
void check_map_settings(const MapSettings& settings);

}  // namespace utsuri
