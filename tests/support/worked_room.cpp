// SPDX-License-Identifier: Apache-2.0
#include "support/worked_room.h"

namespace utsuri::test {
namespace {

constexpr unsigned kLowerZ = 1u << 4;

}  // namespace

Scene worked_room() {
    Scene scene;
    kWorkedRoom.add_to(scene, kLowerZ);
    add(scene, quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), mirror());
    return scene;
}

CodedWalls turned_worked_walls() {
    return turned_room({0, 0, 0}, {4, 3, 5}, kWorkedTurn);
}

Scene turned_worked_room() {
    Scene scene;
    turned_worked_walls().add_to(scene, kLowerZ);
    add(scene, quad({0, 0, 0}, glm::vec3(turned({4, 0, 0}, kWorkedTurn)), {0, 3, 0}), mirror());
    return scene;
}

Scene HexagonalHall::scene() const {
    Scene scene;
    walls.add_to(scene);
    add(scene, quad({0, 0.3f, -1.3f}, {2.2f, 0, 0}, {0, 2, 0}), mirror());
    return scene;
}

}  // namespace utsuri::test
