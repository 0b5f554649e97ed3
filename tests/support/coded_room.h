// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/scenes.h"

namespace utsuri::test {

/// A room whose walls shine with their own position: red, green and blue at a point of a wall are its x, y
/// and z, each from 0 at the lower to 1 at the upper corner. The coding is linear on a wall (a texture of two
/// by two texels, filtered linearly between their centres) and continuous around edges and corners, so that
/// radiance tells where a ray ended.
class CodedRoom {
  public:
    CodedRoom(glm::dvec3 lower, glm::dvec3 upper) : lower_(lower), upper_(upper) {}

    /// Adds the walls, as six instances, with their materials and textures; walls for which `left_out` has
    /// bit 2 * axis + (upper ? 1 : 0) set are not added.
    void add_to(Scene& scene, unsigned left_out = 0) const;

    /// The point that shines with `radiance`.
    [[nodiscard]] glm::dvec3 decode(const glm::dvec3& radiance) const {
        return lower_ + radiance * (upper_ - lower_);
    }
    /// Where a ray from inside meets the walls.
    [[nodiscard]] glm::dvec3 wall_point(const glm::dvec3& origin, const glm::dvec3& direction) const;

  private:
    glm::dvec3 lower_;
    glm::dvec3 upper_;
};

/// Angle between two directions of any length, radians.
double angle_between(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace utsuri::test
