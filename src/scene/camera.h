// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <string>

namespace utsuri {

/// A pinhole camera in world space. The axes are orthonormal, to three decimals at least.
struct Camera {
    std::string name;
    glm::dvec3 position{0.0};                  ///< metres, finite
    glm::dvec3 right{1.0, 0.0, 0.0};           ///< +x of the picture
    glm::dvec3 up{0.0, 1.0, 0.0};              ///< +y of the picture
    glm::dvec3 forward{0.0, 0.0, -1.0};        ///< viewing direction
    double vertical_fov = 0.7853981633974483;  ///< radians, (0, pi)
};

}  // namespace utsuri
