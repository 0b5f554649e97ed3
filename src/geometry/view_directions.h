// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace utsuri {

/// Evenly spread unit vectors (spherical Fibonacci points).
std::vector<glm::dvec3> view_directions(int count);

}  // namespace utsuri
