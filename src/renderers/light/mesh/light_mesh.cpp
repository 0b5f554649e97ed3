// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/light_mesh.h"

#include "base/check.h"

namespace utsuri {
namespace {

bool same_point(const LightMesh& a, std::uint32_t i, const LightMesh& b, std::uint32_t j) {
    if (i == interop::NONE || j == interop::NONE) return i == j;
    return a.points[i].front == b.points[j].front && a.points[i].back == b.points[j].back;
}

/// Whether two nodes and all below them keep the same light. Trees are no deeper than their triangles are
/// finely split: some tens of levels.
bool same_light(const LightMesh& a, std::uint32_t i, const LightMesh& b, std::uint32_t j) {
    const interop::LightMeshNode& x = a.nodes[i];
    const interop::LightMeshNode& y = b.nodes[j];
    if (x.split != y.split) return false;
    if (x.split == interop::LIGHT_MESH_LEAF) {
        return same_point(a, x.first, b, y.first) && same_point(a, x.second, b, y.second) &&
               same_point(a, x.third, b, y.third);
    }
    return x.second == y.second && same_light(a, x.first, b, y.first) &&
           same_light(a, x.first + 1, b, y.first + 1);
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
