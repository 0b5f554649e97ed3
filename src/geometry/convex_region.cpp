// SPDX-License-Identifier: Apache-2.0
#include "geometry/convex_region.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace utsuri {
namespace {

/// Of lengths that differ by rounding alone, in float64, after some cancellation.
constexpr double kSame = 1e-9;

/// Where three planes meet, for all of them, as far as it lies in all half spaces. A corner of more than
/// three planes comes several times.
std::vector<glm::dvec3> corners_of(const std::vector<HalfSpace>& planes) {
    const auto holds = [&](const glm::dvec3& corner) {
        return std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
            return glm::dot(plane.normal, corner) - plane.offset <=
                   kSame * (std::abs(plane.offset) + glm::length(corner));
        });
    };
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const glm::dvec3 edge = glm::cross(planes[i].normal, planes[j].normal);
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                const double volume = glm::dot(edge, planes[k].normal);
                if (std::abs(volume) <= kSame) continue;
                const glm::dvec3 corner = (planes[i].offset * glm::cross(planes[j].normal, planes[k].normal) +
                                           planes[j].offset * glm::cross(planes[k].normal, planes[i].normal) +
                                           planes[k].offset * edge) /
                                          volume;
                if (holds(corner)) corners.push_back(corner);
            }
        }
    }
    return corners;
}

/// The mean of the corners, if no plane holds all of them.
std::optional<glm::dvec3> point_inside(const std::vector<HalfSpace>& planes) {
    const std::vector<glm::dvec3> corners = corners_of(planes);
    if (corners.empty()) return std::nullopt;
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& corner : corners)
        sum += corner;
    const glm::dvec3 mean = sum / static_cast<double>(corners.size());
    double radius = 0.0;
    for (const glm::dvec3& corner : corners)
        radius = std::max(radius, glm::distance(corner, mean));
    const bool is_inside = std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
        return plane.offset - glm::dot(plane.normal, mean) > kSame * radius;
    });
    return is_inside ? std::optional(mean) : std::nullopt;
}

/// Twice the area of a face, along its normal or against it.
glm::dvec3 doubled_area(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 area(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return area;
}

/// Areas of the faces of a closed polyhedron, each along its normal, cancel. A face without bounds has no
/// corners, and is missed.
bool is_closed(const Polyhedron& polyhedron) {
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (std::size_t i = 0; i < polyhedron.planes.size(); ++i) {
        const double area = glm::length(doubled_area(face_corners(polyhedron, i)));
        sum += area * polyhedron.planes[i].normal;
        total += area;
    }
    // Corners are cut out of squares a million times as wide as their planes are far.
    constexpr double kOpen = 1e-6;
    return total > 0.0 && glm::length(sum) <= kOpen * total;
}

}  // namespace

std::optional<ConvexRegion> enclosed_region(const std::vector<HalfSpace>& planes) {
    const std::optional<glm::dvec3> inside = point_inside(planes);
    if (!inside) return std::nullopt;
    ConvexRegion region{*inside, {}};
    for (const HalfSpace& plane : moved_to(*inside, planes))
        region.about_inside.planes.push_back({plane.normal, plane.offset});
    return is_closed(region.about_inside) ? std::optional(region) : std::nullopt;
}

std::optional<Bounds> box_of(const std::vector<HalfSpace>& planes) {
    if (planes.size() != 6) return std::nullopt;
    Bounds box;
    bool found[6] = {};
    for (const HalfSpace& plane : planes) {
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(plane.normal[axis]) != 1.0) continue;
            const bool is_upper = plane.normal[axis] > 0.0;
            (is_upper ? box.upper : box.lower)[axis] =
                static_cast<float>(is_upper ? plane.offset : -plane.offset);
            found[2 * axis + (is_upper ? 1 : 0)] = true;
        }
    }
    const bool is_box = std::all_of(std::begin(found), std::end(found), [](bool side) { return side; });
    return is_box ? std::optional(box) : std::nullopt;
}

std::vector<HalfSpace> moved_to(const glm::dvec3& origin, std::vector<HalfSpace> planes) {
    for (HalfSpace& plane : planes)
        plane.offset -= glm::dot(plane.normal, origin);
    return planes;
}

}  // namespace utsuri
