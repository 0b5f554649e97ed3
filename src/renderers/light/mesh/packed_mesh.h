// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/mesh/light_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace utsuri {

/// Four words, as which kernels read nodes of a packed mesh.
using MeshTexel = std::array<std::uint32_t, 4>;

/// A mesh as kernels read it: interop/light_mesh.h.
struct PackedMesh {
    std::vector<MeshTexel> nodes;  ///< a LightMeshRoot of each triangle; then LightMeshSplits and cells
    std::vector<interop::LightMeshSide> sides;
};

/// Bytes of a packed mesh, at most: of nodes, roots apart, and of sides.
struct PackedBytes {
    std::uint64_t nodes;
    std::uint64_t sides;
};
/// For each point of the mesh: of a large mesh a point has two leaves (Euler).
PackedBytes packed_bytes_per_point();

/// Points of a mesh of so many triangles whose nodes and sides fit into a buffer each.
std::uint64_t most_packed_points(std::uint64_t triangles, std::uint64_t buffer_bytes);

/// Makes light on leaves a linear function of places on their triangle, and gives every triangle a grid that
/// tells which part of its tree holds a cell of it: so that light is looked up in few steps however deep the
/// tree is.
/// @param roots how many nodes are whole triangles
PackedMesh pack(const LightMesh& mesh, std::uint32_t roots);

}  // namespace utsuri
