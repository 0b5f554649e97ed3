// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/plane_mirrors.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace utsuri {
namespace {

/// Largest relative error of one rounding to float32.
constexpr double kUnitRoundoff = 0x1p-24;
/// Of unit normals: three components rounded when the mesh was made, and again when the scene was placed.
constexpr double kNormalTolerance = 8.0 * kUnitRoundoff;

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const SceneData& scene, std::uint32_t triangle) {
    const interop::BvhTriangle& t = scene.bvh.triangles[triangle];
    return {glm::dvec3(t.v0), glm::dvec3(t.v1), glm::dvec3(t.v2)};
}

/// Bound on how far a vertex is from where it belongs: each coordinate rounded once.
double vertex_error(const SceneData& scene) {
    const glm::dvec3 largest =
        glm::max(glm::abs(glm::dvec3(scene.bounds.lower)), glm::abs(glm::dvec3(scene.bounds.upper)));
    return kUnitRoundoff * glm::length(largest);
}

/// Sine of the angle between two lines.
double sine_between(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(a, b)) / (glm::length(a) * glm::length(b));
}

/// A triangle that a mirror is grown from.
struct Seed {
    std::uint32_t triangle;
    double area;
};

/// The plane of a seed, and what belongs to it.
class SeedPlane {
  public:
    SeedPlane(const SceneData& scene, std::uint32_t triangle)
        : scene_(scene), error_(vertex_error(scene)), corners_(corners_of(scene, triangle)) {
        const glm::dvec3 cross = glm::cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
        const glm::dvec3 shading(scene.normals[scene.triangle_infos[triangle].vertices.x]);
        double longest = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            longest = std::max(longest, glm::distance(corners_[i], corners_[(i + 1) % 3]));
        height_ = glm::length(cross) / longest;
        // The shading normal says more exactly than rounded vertices what plane is meant.
        normal_ = glm::normalize(shading) * (glm::dot(shading, cross) < 0.0 ? -1.0 : 1.0);
        centre_ = (corners_[0] + corners_[1] + corners_[2]) / 3.0;
        flat_ = sine_between(cross, shading) <= kNormalTolerance + 3.0 * error_ / height_ && holds(triangle);
    }

    /// Whether the seed itself is a plane mirror; without, it has a curved look.
    [[nodiscard]] bool flat() const { return flat_; }
    [[nodiscard]] const glm::dvec3& normal() const { return normal_; }
    [[nodiscard]] const glm::dvec3& centre() const { return centre_; }

    /// Whether all corners of a triangle lie in the plane, with normals along its own.
    [[nodiscard]] bool holds(std::uint32_t triangle) const {
        const glm::uvec3& vertices = scene_.triangle_infos[triangle].vertices;
        const Corners corners = corners_of(scene_, triangle);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 normal(scene_.normals[vertices[k]]);
            if (!(sine_between(normal, normal_) <= kNormalTolerance)) return false;
            const glm::dvec3 from_centre = corners[static_cast<std::size_t>(k)] - centre_;
            if (std::abs(glm::dot(from_centre, normal_)) > tolerance(glm::length(from_centre))) return false;
        }
        return true;
    }

    /// How far from the plane rounding may put a vertex at a distance from the centre: its own error, and
    /// that of the seed's corners, extrapolated with the seed's barycentric coordinates.
    [[nodiscard]] double tolerance(double distance) const {
        return error_ * (2.0 + 3.0 * distance / height_);
    }

  private:
    const SceneData& scene_;
    double error_;
    Corners corners_;
    double height_ = 0.0;
    glm::dvec3 normal_{0.0};
    glm::dvec3 centre_{0.0};
    bool flat_ = false;
};

/// The rectangle with a side along `side` around all corners of the mirror, in its plane.
std::array<glm::dvec3, 4> rectangle_along(const SceneData& scene, const PlaneMirror& mirror,
                                          const glm::dvec3& side) {
    const glm::dvec3 u = glm::normalize(side - glm::dot(side, mirror.normal) * mirror.normal);
    const glm::dvec3 v = glm::cross(mirror.normal, u);
    glm::dvec2 lower(std::numeric_limits<double>::infinity());
    glm::dvec2 upper(-lower);
    for (const std::uint32_t triangle : mirror.triangles) {
        for (const glm::dvec3& corner : corners_of(scene, triangle)) {
            const glm::dvec2 place(glm::dot(corner, u), glm::dot(corner, v));
            lower = glm::min(lower, place);
            upper = glm::max(upper, place);
        }
    }
    const glm::dvec3 foot = mirror.offset * mirror.normal;
    return {foot + lower.x * u + lower.y * v, foot + upper.x * u + lower.y * v,
            foot + upper.x * u + upper.y * v, foot + lower.x * u + upper.y * v};
}

/// The smallest of the rectangles along the edges of the seed.
std::array<glm::dvec3, 4> outline_of(const SceneData& scene, const PlaneMirror& mirror, std::uint32_t seed) {
    const Corners corners = corners_of(scene, seed);
    std::array<glm::dvec3, 4> best{};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto rectangle = rectangle_along(scene, mirror, corners[(i + 1) % 3] - corners[i]);
        const double area =
            glm::distance(rectangle[0], rectangle[1]) * glm::distance(rectangle[1], rectangle[2]);
        if (area < least) best = rectangle;
        least = std::min(least, area);
    }
    return best;
}

/// Moves what lies in the plane of the seed from `left` to a mirror.
std::optional<PlaneMirror> take_mirror(const SceneData& scene, std::uint32_t seed,
                                       std::vector<std::uint32_t>& left) {
    const SeedPlane plane(scene, seed);
    if (!plane.flat()) return std::nullopt;
    PlaneMirror mirror;
    mirror.normal = plane.normal();
    mirror.offset = glm::dot(plane.normal(), plane.centre());
    const auto others =
        std::stable_partition(left.begin(), left.end(), [&](std::uint32_t t) { return !plane.holds(t); });
    mirror.triangles.assign(others, left.end());
    left.erase(others, left.end());
    for (const std::uint32_t triangle : mirror.triangles) {
        for (const glm::dvec3& corner : corners_of(scene, triangle))
            mirror.tolerance =
                std::max(mirror.tolerance, plane.tolerance(glm::distance(corner, plane.centre())));
    }
    mirror.outline = outline_of(scene, mirror, seed);
    return mirror;
}

}  // namespace

PlaneMirrors find_plane_mirrors(const SceneData& scene) {
    PlaneMirrors found;
    std::vector<Seed> seeds;
    for (std::uint32_t t = 0; t < scene.triangle_infos.size(); ++t) {
        if (!scene.requirements.surfaces[scene.triangle_infos[t].material].specular) continue;
        found.others.push_back(t);
        const Corners corners = corners_of(scene, t);
        seeds.push_back({t, glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]))});
    }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [](const Seed& a, const Seed& b) { return a.area > b.area; });
    for (const Seed& seed : seeds) {
        if (found.mirrors.size() == kMostPlaneMirrors || !(seed.area > 0.0)) break;
        if (!std::binary_search(found.others.begin(), found.others.end(), seed.triangle)) continue;
        if (auto mirror = take_mirror(scene, seed.triangle, found.others))
            found.mirrors.push_back(std::move(*mirror));
    }
    return found;
}

}  // namespace utsuri
