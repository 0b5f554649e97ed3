// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace utsuri {

/// Largest relative error of one rounding to float32.
inline constexpr double kUnitRoundoff = 0x1p-24;

using Corners = std::array<glm::dvec3, 3>;
Corners corners_of(const SceneData& scene, std::uint32_t triangle);

Bounds bounds_of(const interop::BvhTriangle& triangle);

/// Along the normal of the front, as long as the triangle's area twice.
glm::dvec3 doubled_area(const Corners& corners);

/// Triangles of an instance, ascending: looked up, not searched for, and valid until the data changes.
/// @param instance below Requirements::instances
std::span<const std::uint32_t> triangles_of(const SceneData& scene, std::uint32_t instance);

/// The material of an instance that has triangles.
std::uint32_t material_of(const SceneData& scene, std::uint32_t instance);

/// Where an instance is, scene space; empty if it has no triangles.
const Bounds& bounds_of(const SceneData& scene, std::uint32_t instance);

/// Bound on how far a vertex is from where it belongs: each coordinate rounded once.
double vertex_error(const SceneData& scene);

/// The plane of a triangle, and how far from it rounding may put what was modelled in it.
class TrianglePlane {
  public:
    /// @param triangle that has an area
    /// @param normal unit, if known more exactly than from the corners
    TrianglePlane(const SceneData& scene, std::uint32_t triangle, const glm::dvec3& normal);
    /// With the normal of the triangle's front.
    TrianglePlane(const SceneData& scene, std::uint32_t triangle);

    [[nodiscard]] const glm::dvec3& normal() const { return normal_; }
    [[nodiscard]] const glm::dvec3& centre() const { return centre_; }
    /// How far from the plane rounding may put a vertex at a distance from the centre: its own error, and
    /// that of the triangle's corners, extrapolated with its barycentric coordinates.
    [[nodiscard]] double tolerance(double distance) const;
    /// Bound on the angle by which rounding may turn the triangle, radians.
    [[nodiscard]] double turn() const { return 3.0 * error_ / height_; }
    [[nodiscard]] bool holds(const glm::dvec3& point) const;
    /// Whether all corners of another triangle lie in the plane.
    [[nodiscard]] bool holds(std::uint32_t triangle) const;

  private:
    const SceneData& scene_;
    double error_;
    double height_;  ///< least of the triangle
    glm::dvec3 normal_;
    glm::dvec3 centre_;
};

}  // namespace utsuri
