// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/light_tree.h"
#include "interop/scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// A light that is somewhere.
struct TreeLight {
    glm::dvec3 lower{0.0};  ///< of its bounds, scene space
    glm::dvec3 upper{0.0};
    /// Unit: where it shines to, by the cosine. Zero: it shines everywhere.
    glm::dvec3 axis{0.0};
    bool both_sides = false;  ///< it shines along -axis too
    double power = 0.0;       ///< > 0, in one unit for all
};

/// Builds the tree by which lights are chosen (Conty Estevez and Kulla 2018), by binned costs of power times
/// solid angle times size, at the median where it would get more than LIGHT_TREE_LEVELS levels. It depends on
/// nothing but the lights, and not on their scale by a power of two.
/// @param of the lights, in the order of `infos`; sets path and path_length of these
/// @param first_light index of the first of them among all lights
/// @returns nodes, the root first; for one light a node whose second child has no power
std::vector<interop::LightTreeNode> build_light_tree(std::span<const TreeLight> lights,
                                                     std::span<interop::LightInfo> infos,
                                                     std::uint32_t first_light);

}  // namespace utsuri
