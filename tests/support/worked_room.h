// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/coded_room.h"
#include "support/coded_walls.h"

#include <glm/vec3.hpp>

#include <array>
#include <numbers>
#include <vector>

namespace utsuri::test {

/// A room worked by hand: [0,4] x [0,3] x [0,5] with a mirror for its wall z = 0.
inline const CodedRoom kWorkedRoom({0, 0, 0}, {4, 3, 5});
inline const glm::dvec3 kWorkedEye(1, 1.6, 4);
inline const glm::dvec3 kWorkedCapturePoint(2, 1.5, 2.5);

struct WorkedPoint {
    glm::dvec3 mirror;    ///< where the eye looks
    glm::dvec3 hit;       ///< what is reflected there
    glm::dvec3 infinite;  ///< what a map captured at the capture point shows there, taken as infinitely far
};

/// By hand for the eye: r = reflect(p - eye); the walls that p + t r and c + t r meet.
inline const std::array<WorkedPoint, 4> kWorkedPoints = {{{{2.5, 2, 0}, {4, 2.4, 4}, {2.9375, 1.75, 5}},
                                                          {{2, 1.5, 0}, {3.25, 1.375, 5}, {2.625, 1.4375, 5}},
                                                          {{1, 1, 0}, {1, 0.25, 5}, {2, 1.125, 5}},
                                                          {{3, 2.5, 0}, {4, 2.95, 2}, {3.25, 2.0625, 5}}}};

/// The mirror is the last instance.
Scene worked_room();

/// The same turned about the world's y axis by 30 degrees: points of it are turned(p, kWorkedTurn).
inline constexpr double kWorkedTurn = std::numbers::pi / 6.0;
CodedWalls turned_worked_walls();
Scene turned_worked_room();

/// A hexagonal room with a mirror that faces z, and an eye before it.
struct HexagonalHall {
    CodedWalls walls = hexagonal_room({1, 0, -0.5}, 3.0, 2.8, std::numbers::pi / 18.0);
    glm::dvec3 eye{0.2, 1.6, 1.2};
    glm::dvec3 capture_point{0.8, 1.4, 0.2};
    /// That show places a hand's breadth and more from where walls meet, of three walls.
    std::vector<glm::dvec3> mirror_points{
        {0.6, 1.2, -1.3}, {1.0, 1.5, -1.3}, {0.4, 0.7, -1.3}, {1.9, 1.0, -1.3}};

    /// The mirror is the last instance.
    [[nodiscard]] Scene scene() const;
};

}  // namespace utsuri::test
