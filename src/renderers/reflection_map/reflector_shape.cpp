// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/reflector_shape.h"

#include "renderers/reflection_map/view_directions.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

namespace utsuri {
namespace {

struct Triangle {
    glm::dvec3 corners[3];
    glm::dvec3 normal;  ///< unit; zero where the triangle has no area
};

std::vector<Triangle> triangles_of(const SceneData& scene, std::uint32_t instance) {
    std::vector<Triangle> triangles;
    for (std::size_t t = 0; t < scene.triangle_infos.size(); ++t) {
        if (scene.triangle_infos[t].instance != instance) continue;
        const interop::BvhTriangle& corners = scene.bvh.triangles[t];
        Triangle triangle{{corners.v0, corners.v1, corners.v2}, {}};
        const glm::dvec3 area =
            glm::cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]);
        const double length = glm::length(area);
        if (length > 0.0) triangle.normal = area / length;
        triangles.push_back(triangle);
    }
    return triangles;
}

/// How far rounding can put a vertex off its place: half a unit in the last place of the largest coordinate,
/// for the vertex and for the plane it is held against.
double rounding_of(const std::vector<Triangle>& triangles) {
    double largest = 0.0;
    for (const Triangle& triangle : triangles) {
        for (const glm::dvec3& corner : triangle.corners)
            largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    constexpr double kUnitRoundoff = 0x1p-24;
    return 8.0 * kUnitRoundoff * largest;
}

/// The plane of the largest triangle, if it holds all of them.
std::optional<MirrorPlane> common_plane(const std::vector<Triangle>& triangles, double tolerance) {
    const auto area = [](const Triangle& t) {
        return glm::length(glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
    };
    const auto largest =
        std::max_element(triangles.begin(), triangles.end(),
                         [&](const Triangle& a, const Triangle& b) { return area(a) < area(b); });
    if (largest == triangles.end() || largest->normal == glm::dvec3(0.0)) return std::nullopt;
    const MirrorPlane plane{largest->normal, glm::dot(largest->normal, largest->corners[0])};
    for (const Triangle& triangle : triangles) {
        for (const glm::dvec3& corner : triangle.corners) {
            if (std::abs(glm::dot(plane.normal, corner) - plane.distance) > tolerance) return std::nullopt;
        }
    }
    return plane;
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
    const std::vector<Triangle> triangles = triangles_of(scene, instance);
    const double tolerance = rounding_of(triangles);
    ReflectorShape shape;
    shape.plane = common_plane(triangles, tolerance);
    shape.convex = shape.plane.has_value() || no_vertex_is_outside(triangles, tolerance);
    if (!shape.plane) return shape;
    MirrorPlane& plane = *shape.plane;
    glm::dvec3 lower(std::numeric_limits<double>::infinity());
    glm::dvec3 upper = -lower;
    for (const Triangle& triangle : triangles) {
        for (const glm::dvec3& corner : triangle.corners) {
            lower = glm::min(lower, corner);
            upper = glm::max(upper, corner);
        }
    }
    const glm::dvec3 point = 0.5 * (lower + upper);
    if (openness(scene, instance, point, -plane.normal) > openness(scene, instance, point, plane.normal))
        plane = {-plane.normal, -plane.distance};
    return shape;
}

}  // namespace utsuri
