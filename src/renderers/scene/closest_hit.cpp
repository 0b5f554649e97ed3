// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/closest_hit.h"

namespace utsuri {

std::optional<ReferenceHit> closest_hit_without(const SceneData& scene, std::uint32_t instance,
                                                const glm::dvec3& origin, const glm::dvec3& direction,
                                                double t_max) {
    return closest_hit_reference(scene.bvh, origin, direction, t_max, [&](std::uint32_t triangle) {
        return scene.triangle_infos[triangle].instance != instance;
    });
}

}  // namespace utsuri
