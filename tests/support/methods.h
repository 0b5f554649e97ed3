// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection_map/map_renderer.h"
#include "support/scenes.h"

namespace utsuri::test {

/// All ways to look reflections up in maps.
inline constexpr MapKind kMapKinds[] = {MapKind::polygon, MapKind::sphere,   MapKind::cube,
                                        MapKind::proxy,   MapKind::distance, MapKind::hybrid};

/// Renders a method that looks reflections up in maps.
Traced render_with_maps(Device& device, const Scene& scene, const Camera& camera,
                        const RenderSettings& settings, MapKind kind, const MapSettings& maps,
                        std::uint32_t samples);

/// A room of textured and plain walls with an emissive panel, a point, a spot and a directional light, a
/// mirror ball, a plane mirror and a rough metal ball: every kind of light and surface there is, in 700
/// triangles.
Scene everything_scene();
Camera everything_camera();

}  // namespace utsuri::test
