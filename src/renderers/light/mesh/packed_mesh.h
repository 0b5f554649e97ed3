// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/mesh/light_mesh.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Nodes of a packed mesh for each of its points, at most: a point of a large mesh has two leaves (Euler),
/// and these as many nodes above them.
inline constexpr std::uint64_t kPackedNodesPerPoint = 4;

/// Nodes of a packed mesh, at most: LightMeshNode::head has so many bits for where children are.
inline constexpr std::uint64_t kMostPackedNodes = std::uint64_t{1} << 24;

/// A mesh as kernels read it: interop/light_mesh.h.
struct PackedMesh {
    std::vector<interop::LightMeshNode> nodes;
    std::vector<interop::LightMeshPoint> points;
};

/// Puts halvings that follow each other into one node, so that light is looked up in few steps, and what is
/// near each other on the surface side by side.
/// @param roots how many nodes are whole triangles
PackedMesh pack(const LightMesh& mesh, std::uint32_t roots);

}  // namespace utsuri
