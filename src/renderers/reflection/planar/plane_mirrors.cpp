// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/plane_mirrors.h"

#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace utsuri {
namespace {

/// Of unit normals: three components rounded when the mesh was made, and again when the scene was placed.
constexpr double kNormalTolerance = 8.0 * kUnitRoundoff;

/// Sine of the angle between two lines.
double sine_between(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(a, b)) / (glm::length(a) * glm::length(b));
}

/// A triangle that a mirror is grown from.
struct Seed {
    std::uint32_t triangle;
    double area;
};

/// The shading normal of a triangle's first corner, turned to the triangle's front: it says more exactly than
/// rounded vertices what plane is meant.
glm::dvec3 meant_normal(const SceneData& scene, std::uint32_t triangle) {
    const glm::dvec3 shading(scene.normals[scene.triangle_infos[triangle].vertices.x]);
    const glm::dvec3 area = doubled_area(corners_of(scene, triangle));
    return glm::normalize(shading) * (glm::dot(shading, area) < 0.0 ? -1.0 : 1.0);
}

/// Whether the corners of a triangle lie in a plane, with shading normals along its own.
bool reflects_in(const SceneData& scene, const TrianglePlane& plane, std::uint32_t triangle) {
    const glm::uvec3& vertices = scene.triangle_infos[triangle].vertices;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 normal(scene.normals[vertices[k]]);
        if (!(sine_between(normal, plane.normal()) <= kNormalTolerance)) return false;
    }
    return plane.holds(triangle);
}

/// Whether a seed is a plane mirror by itself; if not, it has a curved look.
bool is_flat(const SceneData& scene, const TrianglePlane& plane, std::uint32_t seed) {
    const glm::dvec3 area = doubled_area(corners_of(scene, seed));
    return sine_between(area, plane.normal()) <= kNormalTolerance + plane.turn() &&
           reflects_in(scene, plane, seed);
}

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
    const TrianglePlane plane(scene, seed, meant_normal(scene, seed));
    if (!is_flat(scene, plane, seed)) return std::nullopt;
    PlaneMirror mirror;
    mirror.normal = plane.normal();
    mirror.offset = glm::dot(plane.normal(), plane.centre());
    const auto others = std::stable_partition(left.begin(), left.end(),
                                              [&](std::uint32_t t) { return !reflects_in(scene, plane, t); });
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
        if (!scene.requirements.surfaces[scene.triangle_infos[t].material].mirror) continue;
        found.others.push_back(t);
        seeds.push_back({t, glm::length(doubled_area(corners_of(scene, t)))});
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
