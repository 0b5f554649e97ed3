// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

namespace utsuri {

/// Transforms a scene's geometry and builds its BVH. Of triangle infos all but the light is set.
/// @param data with its requirements
void make_geometry(const Scene& scene, SceneData& data);

/// What a change did to the geometry of a scene. Where it did nothing, what was there before was moved, not
/// copied.
enum class GeometryChange {
    none,
    attributes,  ///< nodes and triangles of the BVH stay; normals or texcoords may be others
    moved,       ///< the BVH is refitted: triangles have their numbers, and there are as many nodes
    rebuilt      ///< other triangles, of other numbers, about another origin: make_geometry()
};

/// Geometry of a scene that has changed. The BVH is built anew only if there is another number of triangles,
/// or some join other vertices.
/// @param before gives up what stays
/// @param data with its requirements
GeometryChange follow_geometry(SceneData& before, const Scene& scene, SceneData& data);

}  // namespace utsuri
