// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/light_mesh.h"
#include "interop/prelude.h"

#include <array>
#include <cstdint>
#include <vector>

namespace utsuri {

/// MeshNode::split of nodes that are not split.
inline constexpr std::uint32_t kMeshLeaf = 3;

/// Splits above a leaf, at most. Halving any triangle down to rounding takes fewer.
inline constexpr std::uint32_t kMeshDepth = 192;

/// A triangle, split or not: a line from a point on an edge of it to the corner opposite makes two children.
struct MeshNode {
    std::uint32_t split = kMeshLeaf;  ///< 0, 1 or 2: the edge from this corner to the next; kMeshLeaf
    /// Leaf: points at its corners, NONE where no light is kept.
    std::array<std::uint32_t, 3> points{interop::NONE, interop::NONE, interop::NONE};
    float share = 0.0f;  ///< of the way along the edge, in (0, 1); light may jump where it is not exactly 0.5
    /// Child with corners (0, split point, 2), counted from where the edge begins; the one after it has
    /// (split point, 1, 2).
    std::uint32_t child = 0;
};

/// A mesh over every triangle of a scene and the light at its points.
struct LightMesh {
    std::vector<MeshNode> nodes;  ///< roots first, one of each triangle, in device order
    std::vector<interop::LightMeshPoint> points;
};

/// Triangles on which two meshes of as many roots are split in other ways or keep other light; ascending.
std::vector<std::uint32_t> differing_triangles(const LightMesh& a, const LightMesh& b,
                                               std::uint32_t triangles);

}  // namespace utsuri
