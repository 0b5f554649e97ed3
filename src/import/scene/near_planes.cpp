// SPDX-License-Identifier: Apache-2.0
#include "import/scene/near_planes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace utsuri {
namespace {

/// What of a convex polygon is before a plane through the origin, or beside one that is `offset` along the
/// normal (Sutherland and Hodgman 1974).
std::vector<glm::dvec3> before_plane(const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal,
                                     double offset) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double beyond_a = glm::dot(a, normal) - offset;
        const double beyond_b = glm::dot(b, normal) - offset;
        if (beyond_a > 0.0) kept.push_back(a);
        if ((beyond_a > 0.0) != (beyond_b > 0.0))
            kept.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
    }
    return kept;
}

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
            part = before_plane(part, side, 0.0);
        return !before_plane(part, {0, 0, -1}, -near_).empty();
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
