// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// The primitive modes that make triangles, with glTF's numbers.
enum class Topology : int { triangles = 4, triangle_strip = 5, triangle_fan = 6 };

/// The triangles that a list of vertex indices makes (glTF 2.0 specification, section 3.7.2.1). Indices left
/// over at the end of Topology::triangles make none.
std::vector<glm::uvec3> assemble_triangles(Topology topology, std::span<const std::uint32_t> indices);

struct DroppedTriangles {
    std::size_t non_finite = 0;  ///< with a vertex that is infinite or not a number
    std::size_t zero_area = 0;   ///< whose cross product of edges is exactly zero in float64
};

/// Removes the triangles of `mesh` that cannot be drawn.
DroppedTriangles drop_undrawable(Mesh& mesh);

/// Removes the vertices that no triangle uses. Normals and texcoords may be empty.
void drop_unused_vertices(Mesh& mesh);

/// Cross product of two edges: normal to the front, length twice the area.
glm::dvec3 edge_cross(const Mesh& mesh, glm::uvec3 triangle);

}  // namespace utsuri
