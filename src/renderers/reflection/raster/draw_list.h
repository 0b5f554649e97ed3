// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/reflectors/map_kind.h"
#include "renderers/scene/scene_constants.h"
#include "renderers/scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Triangles that one pipeline draws: no pixel pays for a feature that its surface does not have.
struct DrawBatch {
    SurfaceFeatures features;
    std::uint32_t first;  ///< in DrawList::triangles
    std::uint32_t count;
};

/// The triangles of a scene that reflect nothing like a mirror, grouped by what their surfaces need, in
/// device order within a group. ReflectorDrawer draws the others.
struct DrawList {
    std::vector<std::uint32_t> triangles;
    std::vector<DrawBatch> batches;
};

/// @param kind of map; where it traces glossy lobes they are one group, as rays meet textures anyway
DrawList plan_draws(const SceneData& scene, MapKind kind);

/// Whether glossy lobes of surfaces are traced, not looked up in maps.
bool traces_lobes(MapKind kind, const SurfaceFeatures& features);

/// What a pipeline is told that draws surfaces with these features.
/// @param traces whether it sends rays, which meet surfaces of all kinds
Specialization drawing_constants(const Specialization& scene, const SurfaceFeatures& features, bool traces);

}  // namespace utsuri
