// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/scenes.h"

#include <span>

namespace utsuri::test {

/// A square at y = 0 about the origin, facing up, of edge 2 * half.
Mesh ground(float half);
/// One flat triangle, its front where a, b, c run counter-clockwise.
Mesh triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c);
/// The same surface with its front on the other side.
Mesh flipped(Mesh mesh);
/// The same surface, each triangle flat with vertices of its own.
Mesh faceted(const Mesh& mesh);
/// The six sides of a box, with fronts outside.
Mesh block(glm::vec3 lower, glm::vec3 upper);
/// A square parallel to y = 0, facing down, of edge 2 * half.
Mesh ceiling(glm::vec3 centre, float half);

/// Irradiance at a point, over radiance, from a uniform polygon wholly above the point's horizon (Lambert
/// 1760): half the sum over the edges of the angle they subtend times the cosine between the normal and that
/// of their plane.
/// @param corners clockwise as seen from the point
double polygon_irradiance(std::span<const glm::dvec3> corners, const glm::dvec3& point,
                          const glm::dvec3& normal);

}  // namespace utsuri::test
