// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/scenes.h"

#include "geometry/convex_region.h"

#include <vector>

namespace utsuri::test {

/// The walls of a convex room, parallelograms turned any way that shine with their own position: red and
/// green tell where along its edges a point of a wall lies, each from 0 to 1, and blue is the wall's number
/// plus 1, so that radiance tells where a ray ended. Walls may reach beyond the room.
class CodedWalls {
  public:
    /// A wall whose front, where u x v points, is inside.
    void add_wall(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);

    /// Adds walls, each an instance, with their materials and textures; those for which `left_out` has bit i
    /// set are not added.
    void add_to(Scene& scene, unsigned left_out = 0) const;

    /// The point that shines with `radiance`, if that is of one wall alone, to a hundredth of its number.
    [[nodiscard]] glm::dvec3 decode(const glm::dvec3& radiance) const;
    /// Where a ray from inside meets the walls.
    [[nodiscard]] glm::dvec3 wall_point(const glm::dvec3& origin, const glm::dvec3& direction) const;
    /// The half spaces that the room is the meeting of.
    [[nodiscard]] std::vector<HalfSpace> planes() const;

  private:
    struct Wall {
        glm::dvec3 corner;
        glm::dvec3 u;
        glm::dvec3 v;
    };
    std::vector<Wall> walls_;
};

/// A box along the axes, turned about the world's y axis by an angle in radians; walls in the order of
/// CodedRoom.
CodedWalls turned_room(const glm::dvec3& lower, const glm::dvec3& upper, double angle);

/// The turn of turned_room().
glm::dvec3 turned(const glm::dvec3& point, double angle);

/// A prism over a regular hexagon with its centre at (centre.x, centre.z), whose sides are `apothem` away,
/// the first of them where `angle` points, from y = 0 to `height`; the sides, then floor and ceiling, which
/// reach beyond the sides.
CodedWalls hexagonal_room(const glm::dvec3& centre, double apothem, double height, double angle);

}  // namespace utsuri::test
