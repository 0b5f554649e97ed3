// SPDX-License-Identifier: Apache-2.0
#include "geometry/polyhedron.h"

#include "base/error.h"
#include "geometry/plane_file.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace utsuri {
namespace {

constexpr double kGolden = std::numbers::phi;
/// Corners of a face are cut out of a square this many times as far as its plane; beyond counts as unbounded.
constexpr double kFar = 1e6;
/// Planes through a corner agree on it to this share of its distance.
constexpr double kSame = 1e-9;

Polyhedron from_normals(std::string name, const std::vector<glm::dvec3>& normals) {
    Polyhedron result{std::move(name), {}};
    for (const glm::dvec3& normal : normals)
        result.planes.push_back({glm::normalize(normal), 1.0});
    return result;
}

std::vector<glm::dvec3> cube_normals() {
    std::vector<glm::dvec3> normals;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 normal(0.0);
            normal[axis] = sign;
            normals.push_back(normal);
        }
    }
    return normals;
}

std::vector<glm::dvec3> octahedron_normals() {
    std::vector<glm::dvec3> normals;
    normals.reserve(8);
    for (int i = 0; i < 8; ++i)
        normals.emplace_back(i & 4 ? -1 : 1, i & 2 ? -1 : 1, i & 1 ? -1 : 1);
    return normals;
}

/// (0, +-1, +-g) and its cyclic permutations.
void add_golden(std::vector<glm::dvec3>& normals, double one, double g) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 4; ++i) {
            glm::dvec3 normal(0.0);
            normal[(axis + 1) % 3] = i & 2 ? -one : one;
            normal[(axis + 2) % 3] = i & 1 ? -g : g;
            normals.push_back(normal);
        }
    }
}

std::vector<glm::dvec3> dodecahedron_normals() {
    std::vector<glm::dvec3> normals;
    add_golden(normals, 1.0, kGolden);
    return normals;
}

std::vector<glm::dvec3> icosahedron_normals() {
    std::vector<glm::dvec3> normals = octahedron_normals();
    add_golden(normals, kGolden, 1.0 / kGolden);
    return normals;
}

/// Two unit vectors that span the plane, the first along the axes where it can be.
std::array<glm::dvec3, 2> span(const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    int axis = size.x >= size.y ? 0 : 1;
    if (size.z > size[axis]) axis = 2;
    // The two axes that follow the largest one: on the cube these are the picture's own.
    glm::dvec3 right(0.0);
    right[(axis + 1) % 3] = 1.0;
    right = glm::normalize(right - glm::dot(right, normal) * normal);
    glm::dvec3 up = glm::cross(normal, right);
    if (up[(axis + 2) % 3] < 0.0) up = -up;
    return {right, up};
}

/// Keeps the part of a polygon with dot(normal, x) <= distance. Corners that the plane meets stay as they
/// are: more than three faces can meet there.
std::vector<glm::dvec3> cut(const std::vector<glm::dvec3>& polygon, const Polyhedron::Plane& plane) {
    const auto beyond = [&](const glm::dvec3& corner) {
        const double distance = glm::dot(plane.normal, corner) - plane.distance;
        return std::abs(distance) <= kSame * (plane.distance + glm::length(corner)) ? 0.0 : distance;
    };
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double da = beyond(a);
        const double db = beyond(b);
        if (da <= 0.0) kept.push_back(a);
        if (da * db < 0.0) kept.push_back(a + da / (da - db) * (b - a));
    }
    return kept;
}

}  // namespace

Polyhedron cube() {
    return from_normals("cube", cube_normals());
}

Polyhedron platonic_solid(std::string_view name) {
    if (name == "tetrahedron")
        return from_normals("tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
    if (name == "cube") return cube();
    if (name == "octahedron") return from_normals("octahedron", octahedron_normals());
    if (name == "dodecahedron") return from_normals("dodecahedron", dodecahedron_normals());
    if (name == "icosahedron") return from_normals("icosahedron", icosahedron_normals());
    throw UsageError("choose polyhedron", fmt::format("'{}'", name),
                     "there are: tetrahedron, cube, octahedron, dodecahedron, icosahedron, or a file of "
                     "planes, with a dot in its name");
}

Polyhedron read_polyhedron(const std::filesystem::path& path) {
    const PlaneFilePurpose purpose{"read polyhedron", "polyhedron of maps",
                                   "distance from the capture point"};
    Polyhedron result{path.string(), {}};
    for (const PlaneLine& line : read_planes(path, purpose)) {
        if (!(line.plane.offset > 0.0))
            fail_at_line(path, purpose, line.number,
                         "the distance must be positive: the capture point lies inside");
        result.planes.push_back({line.plane.normal, line.plane.offset});
    }
    if (const auto plane = plane_without_face(result)) {
        throw InputError(
            purpose.operation, path.string(),
            fmt::format("plane {} bounds no face: the planes must enclose the capture point, and each must "
                        "touch the polyhedron they enclose",
                        *plane + 1));
    }
    return result;
}

std::vector<glm::dvec3> face_corners(const Polyhedron& polyhedron, std::size_t face) {
    const Polyhedron::Plane& plane = polyhedron.planes[face];
    const auto [right, up] = span(plane.normal);
    const glm::dvec3 centre = plane.distance * plane.normal;
    const double far = kFar * plane.distance;
    std::vector<glm::dvec3> corners = {centre - far * (right + up), centre + far * (right - up),
                                       centre + far * (right + up), centre - far * (right - up)};
    for (std::size_t i = 0; i < polyhedron.planes.size() && !corners.empty(); ++i) {
        if (i == face) continue;
        const Polyhedron::Plane& other = polyhedron.planes[i];
        // Of planes given twice the first has the face.
        const bool same = glm::distance(other.normal, plane.normal) < kSame &&
                          std::abs(other.distance - plane.distance) < kSame * plane.distance;
        if (same && i < face) return {};
        if (!same) corners = cut(corners, other);
    }
    const auto is_far = [&](const glm::dvec3& corner) { return glm::distance(corner, centre) > 0.5 * far; };
    if (std::any_of(corners.begin(), corners.end(), is_far)) return {};
    return corners;
}

std::optional<std::size_t> plane_without_face(const Polyhedron& polyhedron) {
    for (std::size_t i = 0; i < polyhedron.planes.size(); ++i) {
        if (face_corners(polyhedron, i).size() < 3) return i;
    }
    return std::nullopt;
}

FacePicture face_picture(const Polyhedron& polyhedron, std::size_t face) {
    const Polyhedron::Plane& plane = polyhedron.planes[face];
    FacePicture picture{plane.distance * plane.normal, {}, {}};
    const std::array<glm::dvec3, 2> axes = span(plane.normal);
    const std::array<glm::dvec3*, 2> halves = {&picture.right, &picture.up};
    for (std::size_t i = 0; i < 2; ++i) {
        double lower = std::numeric_limits<double>::infinity();
        double upper = -lower;
        for (const glm::dvec3& corner : face_corners(polyhedron, face)) {
            lower = std::min(lower, glm::dot(axes[i], corner));
            upper = std::max(upper, glm::dot(axes[i], corner));
        }
        picture.centre += 0.5 * (lower + upper) * axes[i];
        *halves[i] = 0.5 * (upper - lower) * axes[i];
    }
    return picture;
}

interop::MapFace map_face(const Polyhedron& polyhedron, std::size_t face) {
    const Polyhedron::Plane& plane = polyhedron.planes[face];
    const FacePicture picture = face_picture(polyhedron, face);
    const glm::dvec3 outward = plane.normal / plane.distance;
    // The inverse of centre + x right + y up, for points with dot(outward, point) = 1.
    const auto coordinate = [&](const glm::dvec3& half) {
        return (half - glm::dot(half, picture.centre) * outward) / glm::dot(half, half);
    };
    return {glm::vec3(outward), glm::vec3(coordinate(picture.right)), glm::vec3(coordinate(picture.up)),
            static_cast<float>(std::hypot(glm::length(picture.right), glm::length(picture.up)))};
}

}  // namespace utsuri
