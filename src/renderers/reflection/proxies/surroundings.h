// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

struct SurroundingsSample {
    glm::dvec3 direction;  ///< unit
    double distance;
    std::uint32_t triangle;
};

/// What is seen from the capture point of a reflector, without that, and what is seen of it. Scene space.
struct Surroundings {
    glm::dvec3 point;
    Bounds scene;
    double tolerance;  ///< by which rounding may part what is meant to be in one place
    std::vector<SurroundingsSample>
        samples;  ///< evenly spread; directions in which nothing is met are left out
    /// Places on the reflector, from the point, that nothing hides from it: there its rays start. What
    /// reaches through walls does not count; if all of it is hidden, all counts.
    std::vector<glm::dvec3> starts;
};

Surroundings sample_surroundings(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point);

}  // namespace utsuri
