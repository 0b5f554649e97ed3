// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <limits>

namespace utsuri {

/// An axis-aligned box. The default is empty: lower > upper.
struct Bounds {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};

    void extend(const glm::vec3& point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    void extend(const Bounds& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    [[nodiscard]] bool empty() const { return lower.x > upper.x; }
    [[nodiscard]] glm::vec3 extent() const { return upper - lower; }
    /// Half the surface area, which is all that ratios of areas need. Zero for an empty box.
    [[nodiscard]] float half_area() const {
        if (empty()) return 0.0f;
        const glm::vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

}  // namespace utsuri
