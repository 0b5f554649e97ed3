// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// All instances of a scene as one list of triangles in scene space: world space moved so that `origin`, the
/// centre of the scene, is at zero, where float32 is most accurate. Vertices are transformed once, in
/// float64, so triangles that share a vertex share its bits.
struct WorldGeometry {
    glm::dvec3 origin{0.0};  ///< metres, world space
    Bounds bounds;           ///< scene space
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;        ///< unit, one per position
    std::vector<glm::vec2> texcoords;      ///< one per position; (0, 0) where a mesh has none
    std::vector<glm::uvec3> triangles;     ///< counter-clockwise seen from the front
    std::vector<std::uint32_t> instances;  ///< one per triangle
};

/// @param scene valid: check_scene()
WorldGeometry make_world_geometry(const Scene& scene);
/// With an origin that is given: of a scene that has changed, where it was before.
WorldGeometry make_world_geometry(const Scene& scene, const glm::dvec3& origin);

}  // namespace utsuri
