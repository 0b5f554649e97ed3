// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_triangles.h"
#include "renderers/light/direct/light_cache.h"

namespace utsuri::test {

/// Scene and contents of a cache.
struct Filled {
    SceneData data;
    LightMesh mesh;
    FrameCounts counts;
};

inline Filled fill(Device& device, const Scene& scene, const LightSettings& settings) {
    Filled filled;
    filled.data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device, filled.data);
    LightCache cache(device, filled.data, gpu_scene, settings);
    Progress progress;
    cache.fill(progress);
    filled.counts = cache.cost().counts;
    filled.mesh = cache.mesh();
    return filled;
}

/// Calls visit(corners in scene space, points) for each leaf below a node.
template <typename Visit>
void for_each_leaf(const LightMesh& mesh, std::uint32_t node, const Corners& corners, Visit&& visit) {
    const MeshNode& n = mesh.nodes[node];
    if (n.split == kMeshLeaf) {
        if (n.points[0] != interop::NONE) visit(corners, n.points);
        return;
    }
    const glm::dvec3 a = corners[n.split];
    const glm::dvec3 b = corners[(n.split + 1) % 3];
    const glm::dvec3 c = corners[(n.split + 2) % 3];
    const glm::dvec3 p = glm::mix(a, b, static_cast<double>(n.share));
    for_each_leaf(mesh, n.child, {a, p, c}, visit);
    for_each_leaf(mesh, n.child + 1, {p, b, c}, visit);
}

/// Calls visit(triangle, position in world space, point) for every corner of every leaf.
template <typename Visit>
void for_each_point(const Filled& filled, Visit&& visit) {
    for (std::uint32_t t = 0; t < filled.data.triangle_infos.size(); ++t) {
        for_each_leaf(filled.mesh, t, corners_of(filled.data, t),
                      [&](const Corners& corners, const std::array<std::uint32_t, 3>& points) {
                          for (std::size_t i = 0; i < 3; ++i)
                              visit(t, filled.data.origin + corners[i], filled.mesh.points[points[i]]);
                      });
    }
}

}  // namespace utsuri::test
