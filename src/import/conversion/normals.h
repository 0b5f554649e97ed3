// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <glm/mat3x3.hpp>

#include <cstddef>

namespace utsuri {

/// Gives every triangle its own three vertices with the normal of its plane, as the glTF 2.0 specification
/// (section 3.7.2.1) asks for where normals are absent. No triangle may have zero area.
void make_flat_normals(Mesh& mesh);

/// Makes every normal unit. One of zero length or not finite becomes the area-weighted mean of the normals of
/// the triangles around its vertex, or, where that vanishes, the normal of one of them.
/// @returns the number replaced.
std::size_t repair_normals(Mesh& mesh);

/// True if `linear` flattens space, up to the rounding of a chain of float64 products.
bool is_singular(const glm::dmat3& linear);

/// The mesh after a singular map, with flat normals of its flat triangles. Triangles seen edge-on or shrunk
/// to a point are gone.
Mesh flattened(const Mesh& mesh, const glm::dmat3& linear);

}  // namespace utsuri
