// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"
#include "geometry/half_space.h"
#include "geometry/polyhedron.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace utsuri {

/// What planes enclose, about a point inside it.
struct ConvexRegion {
    glm::dvec3 inside;
    Polyhedron about_inside;  ///< a face for each plane, in their order; some may have no corners
};

/// None if the planes enclose no volume, or leave it open.
std::optional<ConvexRegion> enclosed_region(const std::vector<HalfSpace>& planes);

/// The box that six planes bound, if all are square to the axes.
std::optional<Bounds> box_of(const std::vector<HalfSpace>& planes);

/// The same planes seen from another origin.
std::vector<HalfSpace> moved_to(const glm::dvec3& origin, std::vector<HalfSpace> planes);

}  // namespace utsuri
