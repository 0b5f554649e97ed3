// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace utsuri {

/// Twice the area between two directions in a plane, positive if the second is to the left of the first.
double cross(const glm::dvec2& a, const glm::dvec2& b);

/// Metric coordinates in the plane of a triangle: the origin is its first corner.
class TriangleFrame {
  public:
    /// @param corners of a triangle that has an area
    explicit TriangleFrame(const std::array<glm::dvec3, 3>& corners);

    [[nodiscard]] glm::dvec2 project(const glm::dvec3& point) const;
    /// Signed distance from the plane, positive before the front.
    [[nodiscard]] double height(const glm::dvec3& point) const;
    [[nodiscard]] const std::array<glm::dvec2, 3>& corners() const { return corners_; }
    [[nodiscard]] const glm::dvec3& normal() const { return normal_; }
    [[nodiscard]] double longest_edge() const;

  private:
    glm::dvec3 origin_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    glm::dvec3 normal_;
    std::array<glm::dvec2, 3> corners_{};
};

}  // namespace utsuri
