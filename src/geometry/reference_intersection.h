// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bvh.h"

#include <glm/vec3.hpp>

#include <functional>
#include <limits>
#include <optional>

namespace utsuri {

/// A hit found in float64 on the host: the truth that device kernels are held against, and what little
/// tracing the host itself needs.
struct ReferenceHit {
    double t = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = interop::NONE;  ///< device order
    double b1 = 0.0;                         ///< barycentric coordinates of the second and third vertex
    double b2 = 0.0;
    bool back_face = false;  ///< the ray arrives at the clockwise side
};

/// Hit of one triangle with 0 < t < t_max (Moeller and Trumbore 1997, in float64, both sides).
std::optional<ReferenceHit> intersect_triangle_reference(const interop::BvhTriangle& triangle,
                                                         const glm::dvec3& origin,
                                                         const glm::dvec3& direction, double t_max);

/// Closest hit with 0 < t < t_max among the triangles that `accept` lets through. Distances are in multiples
/// of `direction`.
std::optional<ReferenceHit> closest_hit_reference(
    const Bvh& bvh, const glm::dvec3& origin, const glm::dvec3& direction, double t_max,
    const std::function<bool(std::uint32_t triangle)>& accept = [](std::uint32_t) { return true; });

}  // namespace utsuri
