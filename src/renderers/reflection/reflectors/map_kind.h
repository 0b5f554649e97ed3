// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace utsuri {

/// How maps are made and looked up.
enum class MapKind {
    polygon,   ///< a polyhedron of maps in world space, reflection vectors per vertex
    sphere,    ///< one OpenGL 1.x sphere map in eye space, texture coordinates per vertex
    cube,      ///< a polyhedron of maps, reflection vectors per pixel
    proxy,     ///< the same, corrected by what stands in for the surroundings
    distance,  ///< the same, corrected by the distances kept beside the maps
    hybrid     ///< the same where that is predicted to be right enough, a ray elsewhere
};

/// Whether a kind of map keeps distances beside its radiance.
constexpr bool keeps_distances(MapKind kind) {
    return kind == MapKind::distance || kind == MapKind::hybrid;
}

}  // namespace utsuri
