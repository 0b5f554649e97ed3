// SPDX-License-Identifier: Apache-2.0
#include "geometry/clip_polygon.h"

#include <glm/geometric.hpp>

#include <cstddef>

namespace utsuri {

std::vector<glm::dvec3> clip_polygon(const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal,
                                     double offset) {
    std::vector<glm::dvec3> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(normal, a) - offset;
        const double db = glm::dot(normal, b) - offset;
        if (da > 0.0) result.push_back(a);
        if ((da > 0.0) != (db > 0.0)) result.push_back(a + da / (da - db) * (b - a));
    }
    return result;
}

}  // namespace utsuri
