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

}  // namespace utsuri::test
