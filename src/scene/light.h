// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <string>

namespace utsuri {

enum class LightType { point, spot, directional };

/// A punctual light in world space (KHR_lights_punctual). Emissive triangles are materials, not lights. What
/// a type does not use may have any value.
struct Light {
    std::string name;
    LightType type = LightType::point;
    glm::dvec3 position{0.0};              ///< metres, finite; point and spot
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit, the way the light travels; spot and directional
    glm::vec3 intensity{1.0f};             ///< per channel, >= 0: cd (point, spot) or lux (directional)
    double range = 0.0;                    ///< metres, >= 0: cut-off distance; 0 means unlimited
    double inner_cone_angle = 0.0;         ///< radians, [0, outer]; spot
    double outer_cone_angle = 0.7853981633974483;  ///< radians, (inner, pi/2]; spot
};

}  // namespace utsuri
