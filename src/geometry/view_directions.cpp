// SPDX-License-Identifier: Apache-2.0
#include "geometry/view_directions.h"

#include <cmath>
#include <numbers>

namespace utsuri {

std::vector<glm::dvec3> view_directions(int count) {
    std::vector<glm::dvec3> result;
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double radius = std::sqrt(1.0 - z * z);
        result.emplace_back(radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i), z);
    }
    return result;
}

}  // namespace utsuri
