// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/reflector_shape.h"

#include "renderers/reflection_map/scene_triangles.h"
#include "renderers/reflection_map/view_directions.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace utsuri {
namespace {

struct Triangle {
    Corners corners;
    glm::dvec3 normal;  ///< unit; zero where the triangle has no area
};

std::vector<Triangle> with_normals(const SceneData& scene, const std::vector<std::uint32_t>& triangles) {
    std::vector<Triangle> result;
    for (const std::uint32_t t : triangles) {
        const Corners corners = corners_of(scene, t);
        const glm::dvec3 area = doubled_area(corners);
        const double length = glm::length(area);
        result.push_back({corners, length > 0.0 ? area / length : glm::dvec3(0.0)});
    }
    return result;
}

/// How far rounding can put a vertex off its place: half a unit in the last place of the largest coordinate,
/// for the vertex and for the plane it is held against.
double rounding_of(const std::vector<Triangle>& triangles) {
    double largest = 0.0;
    for (const Triangle& triangle : triangles) {
        for (const glm::dvec3& corner : triangle.corners)
            largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    return 8.0 * kUnitRoundoff * largest;
}

/// The plane of the largest triangle, if it holds all of them.
std::optional<MirrorPlane> common_plane(const SceneData& scene, const std::vector<std::uint32_t>& triangles) {
    const auto area = [&](std::uint32_t t) { return glm::length(doubled_area(corners_of(scene, t))); };
    const auto largest =
        std::max_element(triangles.begin(), triangles.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return area(a) < area(b); });
    if (largest == triangles.end() || !(area(*largest) > 0.0)) return std::nullopt;
    const TrianglePlane plane(scene, *largest);
    if (!std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) { return plane.holds(t); }))
        return std::nullopt;
    return MirrorPlane{plane.normal(), glm::dot(plane.normal(), corners_of(scene, *largest)[0])};
}

bool no_vertex_is_outside(const std::vector<Triangle>& triangles, double tolerance) {
    const auto is_before = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::set<glm::dvec3, decltype(is_before)> vertices(is_before);
    for (const Triangle& triangle : triangles)
        vertices.insert(std::begin(triangle.corners), std::end(triangle.corners));
    if (std::uint64_t{triangles.size()} * vertices.size() > kMostConvexityPairs) return false;
    return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& face) {
        const double limit = glm::dot(face.normal, face.corners[0]) + tolerance;
        return std::none_of(vertices.begin(), vertices.end(),
                            [&](const glm::dvec3& vertex) { return glm::dot(face.normal, vertex) > limit; });
    });
}

/// Mean of how far one sees from a point of a mirror to the side that a normal points to, in diagonals of the
/// scene. Where nothing is met there is nothing to see, unless the scene has surroundings.
double openness(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point,
                const glm::dvec3& normal) {
    constexpr int kDirections = 128;
    const double diagonal = glm::length(glm::dvec3(scene.bounds.extent()));
    double sum = 0.0;
    int count = 0;
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        if (glm::dot(direction, normal) <= 0.0) continue;
        const auto hit = closest_hit_reference(scene.bvh, point, direction, diagonal, [&](std::uint32_t t) {
            return scene.triangle_infos[t].instance != instance;
        });
        ++count;
        if (hit || scene.requirements.environment) sum += hit ? hit->t / diagonal : 1.0;
    }
    return sum / count;
}

}  // namespace

ReflectorShape describe_shape(const SceneData& scene, std::uint32_t instance) {
    const std::vector<std::uint32_t> own = triangles_of(scene, instance);
    const std::vector<Triangle> triangles = with_normals(scene, own);
    ReflectorShape shape;
    shape.plane = common_plane(scene, own);
    shape.convex = shape.plane.has_value() || no_vertex_is_outside(triangles, rounding_of(triangles));
    if (!shape.plane) return shape;
    MirrorPlane& plane = *shape.plane;
    const Bounds bounds = bounds_of(scene, own);
    const glm::dvec3 point = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    if (openness(scene, instance, point, -plane.normal) > openness(scene, instance, point, plane.normal))
        plane = {-plane.normal, -plane.distance};
    return shape;
}

}  // namespace utsuri
