// SPDX-License-Identifier: Apache-2.0
#include "reflector_eyes.h"

#include "support/scenes.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <random>

namespace utsuri::test {

std::vector<Camera> eyes_before_reflectors(const Scene& scene, const SceneData& data, std::size_t count,
                                           unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<Camera> eyes;
    const auto& reflective = data.requirements.reflective_instances;
    while (eyes.size() < count && !reflective.empty()) {
        const glm::dvec3 lower = glm::dvec3(data.bounds.lower) + data.origin;
        const glm::dvec3 size(data.bounds.extent());
        const glm::dvec3 eye = lower + size * glm::dvec3(share(random), share(random), share(random));
        const std::uint32_t instance = reflective[random() % reflective.size()];
        const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
        const glm::uvec3 corners = mesh.triangles[random() % mesh.triangles.size()];
        const double along = share(random);
        const double across = share(random) * (1.0 - along);
        const glm::dvec3 place = (1.0 - along - across) * glm::dvec3(mesh.positions[corners.x]) +
                                 along * glm::dvec3(mesh.positions[corners.y]) +
                                 across * glm::dvec3(mesh.positions[corners.z]);
        const glm::dvec3 target(scene.instances[instance].world_from_object * glm::dvec4(place, 1));
        const auto hit = closest_hit_reference(data.bvh, eye - data.origin, target - eye, 2.0);
        if (hit && !hit->back_face && data.triangle_infos[hit->triangle].instance == instance)
            eyes.push_back(look_at(eye, target, 0.9));
    }
    return eyes;
}

}  // namespace utsuri::test
