// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace utsuri {

/// The part of a convex polygon where dot(normal, x) > offset (Sutherland and Hodgman 1974); may be empty.
std::vector<glm::dvec3> clip_polygon(const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal,
                                     double offset);

}  // namespace utsuri
