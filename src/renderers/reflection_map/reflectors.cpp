// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/reflectors.h"

namespace utsuri {

Reflectors find_reflectors(const SceneData& scene) {
    Reflectors result;
    result.instances = scene.requirements.reflective_instances;
    result.instance_reflectors.assign(scene.requirements.instances, interop::NONE);
    for (std::uint32_t i = 0; i < result.instances.size(); ++i)
        result.instance_reflectors[result.instances[i]] = i;
    result.vertex_slots.assign(scene.normals.size(), interop::NONE);
    for (std::size_t t = 0; t < scene.triangle_infos.size(); ++t) {
        const interop::TriangleInfo& info = scene.triangle_infos[t];
        if (result.instance_reflectors[info.instance] == interop::NONE) continue;
        const interop::BvhTriangle& triangle = scene.bvh.triangles[t];
        const glm::vec3 positions[3] = {triangle.v0, triangle.v1, triangle.v2};
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = info.vertices[k];
            if (result.vertex_slots[vertex] != interop::NONE) continue;
            result.vertex_slots[vertex] = static_cast<std::uint32_t>(result.vertices.size());
            result.vertices.push_back({positions[k], scene.normals[vertex]});
        }
    }
    return result;
}

}  // namespace utsuri
