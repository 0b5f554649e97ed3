// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/light_mesh.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// A point of a large mesh has two leaves (Euler), and these as many nodes above them.
inline constexpr std::uint64_t kMeshNodesPerPoint = 4;

/// A mesh over every triangle of a scene and the light at its points: interop/light_mesh.h.
struct LightMesh {
    std::vector<interop::LightMeshNode> nodes;  ///< roots first, one of each triangle, in device order
    std::vector<interop::LightMeshPoint> points;

    /// Bytes on the device.
    [[nodiscard]] std::uint64_t bytes() const {
        return nodes.size() * sizeof(interop::LightMeshNode) +
               points.size() * sizeof(interop::LightMeshPoint);
    }
};

/// Triangles on which two meshes of as many roots are split in other ways or keep other light; ascending.
std::vector<std::uint32_t> differing_triangles(const LightMesh& a, const LightMesh& b,
                                               std::uint32_t triangles);

}  // namespace utsuri
