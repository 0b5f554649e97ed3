// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

namespace utsuri {

/// A half space: dot(normal, x) <= offset.
struct HalfSpace {
    glm::dvec3 normal;  ///< unit, out of it
    double offset;
};

}  // namespace utsuri
