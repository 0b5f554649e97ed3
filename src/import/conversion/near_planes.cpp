// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/near_planes.h"

#include "geometry/clip_polygon.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace utsuri {
namespace {

/// The part of the view that a near plane cuts off.
class CutOff {
  public:
    CutOff(const Camera& camera, double near) : camera_(camera), near_(near) {
        // As wide as it is high: what is in there is in every picture that is not upright.
        const double half = 0.5 * camera.vertical_fov;
        const double inward = std::cos(half);
        const double ahead = std::sin(half);
        sides_ = {glm::dvec3(inward, 0, ahead), glm::dvec3(-inward, 0, ahead), glm::dvec3(0, inward, ahead),
                  glm::dvec3(0, -inward, ahead)};
    }

    [[nodiscard]] bool holds_some_of(const Scene& scene) const {
        return std::any_of(scene.instances.begin(), scene.instances.end(),
                           [&](const Instance& instance) { return holds_some_of(scene, instance); });
    }

  private:
    /// Right, up and forward of the camera.
    [[nodiscard]] glm::dvec3 seen(const glm::dvec3& world) const {
        const glm::dvec3 way = world - camera_.position;
        return {glm::dot(way, camera_.right), glm::dot(way, camera_.up), glm::dot(way, camera_.forward)};
    }

    [[nodiscard]] bool holds_some_of(const Scene& scene, const Instance& instance) const {
        const Mesh& mesh = scene.meshes[instance.mesh];
        std::vector<glm::dvec3> corners;
        corners.reserve(mesh.positions.size());
        for (const glm::vec3& position : mesh.positions)
            corners.push_back(seen(glm::dvec3(instance.world_from_object * glm::dvec4(position, 1.0))));
        return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
            return holds_some_of({corners[t.x], corners[t.y], corners[t.z]});
        });
    }

    [[nodiscard]] bool holds_some_of(const std::array<glm::dvec3, 3>& triangle) const {
        const auto [least, most] = std::minmax({triangle[0].z, triangle[1].z, triangle[2].z});
        if (least >= near_ || most <= 0.0) return false;
        std::vector<glm::dvec3> part(triangle.begin(), triangle.end());
        for (const glm::dvec3& side : sides_)
            part = clip_polygon(part, side, 0.0);
        return !clip_polygon(part, {0, 0, -1}, -near_).empty();
    }

    const Camera& camera_;
    double near_;
    std::array<glm::dvec3, 4> sides_;
};

}  // namespace

void note_near_planes(ImportContext& context) {
    const Scene& scene = context.result.scene;
    for (std::size_t i = 0; i < context.near_planes.size(); ++i) {
        const CutOff cut_off(scene.cameras[i], context.near_planes[i]);
        if (cut_off.holds_some_of(scene))
            context.ignored.add("near planes are not used: what lies before znear is drawn",
                                scene.cameras[i].name);
    }
}

}  // namespace utsuri
