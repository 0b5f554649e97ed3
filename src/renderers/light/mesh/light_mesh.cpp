// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/light_mesh.h"

#include "base/check.h"

namespace utsuri {
namespace {

bool same_point(const LightMesh& a, std::uint32_t i, const LightMesh& b, std::uint32_t j) {
    if (i == interop::NONE || j == interop::NONE) return i == j;
    return a.points[i].front == b.points[j].front && a.points[i].back == b.points[j].back;
}

/// Whether two nodes and all below them keep the same light, kMeshDepth levels at most.
bool same_light(const LightMesh& a, std::uint32_t i, const LightMesh& b, std::uint32_t j) {
    const MeshNode& x = a.nodes[i];
    const MeshNode& y = b.nodes[j];
    if (x.split != y.split) return false;
    if (x.split == kMeshLeaf) {
        return same_point(a, x.points[0], b, y.points[0]) && same_point(a, x.points[1], b, y.points[1]) &&
               same_point(a, x.points[2], b, y.points[2]);
    }
    return x.share == y.share && same_light(a, x.child, b, y.child) &&
           same_light(a, x.child + 1, b, y.child + 1);
}

}  // namespace

std::vector<std::uint32_t> differing_triangles(const LightMesh& a, const LightMesh& b,
                                               std::uint32_t triangles) {
    UTSURI_CHECK_LE(triangles, a.nodes.size());
    UTSURI_CHECK_LE(triangles, b.nodes.size());
    std::vector<std::uint32_t> differing;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        if (!same_light(a, t, b, t)) differing.push_back(t);
    }
    return differing;
}

}  // namespace utsuri
