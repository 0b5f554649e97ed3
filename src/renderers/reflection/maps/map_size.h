// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/reflection/reflectors/map_kind.h"
#include "renderers/reflection/reflectors/probes.h"
#include "renderers/reflection/reflectors/reflectors.h"

#include "scene/camera.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// The picture that maps are made for.
struct MapView {
    Camera camera;
    std::uint32_t width = 512;  ///< pixels
    std::uint32_t height = 384;
};

/// Sizes of maps at which a texel, where it covers most, covers no more of the directions about its probe
/// than a pixel that looks it up sees by way of the reflector. Found for pixels spread over the picture,
/// their rays traced on the host; sharper than that is one look-up in 64. What no pixel sees gets the least
/// size.
/// @param texel_angle root of the largest solid angle that a texel of a map of one texel would cover,
/// radians, if that were small
/// @param most largest size, >= 1
/// @returns texels along an edge of each probe's maps
std::vector<std::uint32_t> fit_map_sizes(const SceneData& scene, const Reflectors& reflectors,
                                         const std::vector<Probe>& probes, MapKind kind, const MapView& view,
                                         double texel_angle, std::uint32_t most);

}  // namespace utsuri
