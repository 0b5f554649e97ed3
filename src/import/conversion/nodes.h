// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/document.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace utsuri {

struct PlacedNode {
    std::size_t node = 0;
    glm::dmat4 world_from_node{1.0};  ///< affine and finite
};

/// The nodes of the scene that is drawn, parents before children: `scene` if given, else scene 0, else every
/// node without a parent. Transforms are composed in float64.
/// @throws InputError if a node has two parents, is below itself, or its transform is not affine and finite.
std::vector<PlacedNode> place_nodes(const Document& document);

/// The name of the scene that is drawn; may be empty.
std::string scene_name(const Document& document);

}  // namespace utsuri
