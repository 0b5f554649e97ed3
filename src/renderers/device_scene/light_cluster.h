// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/light_tree.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace utsuri {

/// Directions within an angle of an axis, radians; from pi on, all of them.
struct DirectionCone {
    glm::dvec3 axis{0.0, 0.0, 1.0};  ///< unit
    double angle = -1.0;             ///< below 0: none
};
/// The least cone about an axis in the plane of both that holds both.
DirectionCone joined(const DirectionCone& a, const DirectionCone& b);

/// What a tree of lights is told of some of them.
struct LightSummary {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
    DirectionCone normals;
    bool both_sides = false;  ///< some shine along their normals turned round
    double power = 0.0;       ///< 0: there are none

    /// Power, times the solid angle into which it goes, times the square of the size: the chance, about, that
    /// choosing by the whole is off.
    [[nodiscard]] double cost() const;
};
LightSummary joined(const LightSummary& a, const LightSummary& b);

/// An axis on an octahedron, as octahedral_axis() of lib/light_importance.glsl unpacks it.
std::uint32_t pack_axis(const glm::dvec3& axis);
glm::dvec3 unpack_axis(std::uint32_t packed);

/// As kernels read it, with room for what is rounded: every light within stays within.
/// @param total power of the whole tree
/// @param child with LIGHT_CLUSTER_LEAF for a light
interop::LightCluster pack_cluster(const LightSummary& lights, double total, std::uint32_t child);

}  // namespace utsuri
