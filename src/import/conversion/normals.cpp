// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/normals.h"

#include "import/conversion/triangles.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace utsuri {
namespace {

/// Rounding in a chain of products leaves about 1e-16 per product relative to the product of the lengths of
/// the columns; 1e-12 allows for thousands.
constexpr double kSingular = 1e-12;

/// A triangle whose edges span less than this, relative to their lengths, was seen edge-on by the flattening
/// map: the rounding of its vertices, 1e-16 of their distance to the origin, then decides its normal. The
/// margin holds for edges down to 1e-5 of that distance.
constexpr double kEdgeOn = 1e-10;

bool is_usable(glm::dvec3 v) {
    const double length2 = glm::dot(v, v);
    return std::isfinite(length2) && length2 > 0.0;
}

/// Every triangle with three vertices of its own; normals left out.
Mesh unshared(const Mesh& mesh) {
    Mesh flat;
    flat.name = mesh.name;
    flat.positions.reserve(3 * mesh.triangles.size());
    flat.texcoords.reserve(mesh.texcoords.empty() ? 0 : 3 * mesh.triangles.size());
    for (const glm::uvec3 triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(flat.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            flat.positions.push_back(mesh.positions[triangle[corner]]);
            if (!mesh.texcoords.empty()) flat.texcoords.push_back(mesh.texcoords[triangle[corner]]);
        }
        flat.triangles.emplace_back(first, first + 1, first + 2);
    }
    return flat;
}

std::vector<glm::dvec3> area_weighted_normals(const Mesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3 triangle : mesh.triangles) {
        const glm::dvec3 cross = edge_cross(mesh, triangle);
        for (int corner = 0; corner < 3; ++corner)
            sums[triangle[corner]] += cross;
    }
    for (const glm::uvec3 triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            if (!is_usable(sums[triangle[corner]])) sums[triangle[corner]] = edge_cross(mesh, triangle);
        }
    }
    return sums;
}

}  // namespace

void make_flat_normals(Mesh& mesh) {
    mesh = unshared(mesh);
    mesh.normals.reserve(mesh.positions.size());
    for (const glm::uvec3 triangle : mesh.triangles) {
        const glm::vec3 normal(glm::normalize(edge_cross(mesh, triangle)));
        mesh.normals.insert(mesh.normals.end(), 3, normal);
    }
}

std::size_t repair_normals(Mesh& mesh) {
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const glm::dvec3 normal(mesh.normals[i]);
        if (is_usable(normal)) {
            mesh.normals[i] = glm::vec3(glm::normalize(normal));
        } else {
            broken.push_back(i);
        }
    }
    if (broken.empty()) return 0;
    const std::vector<glm::dvec3> sums = area_weighted_normals(mesh);
    for (const std::size_t vertex : broken)
        mesh.normals[vertex] = glm::vec3(glm::normalize(sums[vertex]));
    return broken.size();
}

bool is_singular(const glm::dmat3& linear) {
    double largest = 0.0;
    for (int i = 0; i < 9; ++i)
        largest = std::max(largest, std::abs(linear[i / 3][i % 3]));
    if (largest == 0.0) return true;
    // Scaled first, so that neither squares nor products overflow or underflow.
    glm::dmat3 unit;
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 scaled = linear[column] / largest;
        const double length = glm::length(scaled);
        if (length == 0.0) return true;
        unit[column] = scaled / length;
    }
    return std::abs(glm::determinant(unit)) <= kSingular;
}

Mesh flattened(const Mesh& mesh, const glm::dmat3& linear) {
    Mesh flat = unshared(mesh);
    std::size_t kept = 0;
    for (const glm::uvec3 triangle : flat.triangles) {
        glm::dvec3 corners[3];
        for (int corner = 0; corner < 3; ++corner)
            corners[corner] = linear * glm::dvec3(flat.positions[triangle[corner]]);
        const glm::dvec3 edge1 = corners[1] - corners[0];
        const glm::dvec3 edge2 = corners[2] - corners[0];
        const glm::dvec3 cross = glm::cross(edge1, edge2);
        if (!(glm::length(cross) > kEdgeOn * glm::length(edge1) * glm::length(edge2))) continue;
        const glm::vec3 normal(glm::normalize(cross));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            flat.positions[3 * kept + corner] = glm::vec3(corners[corner]);
            if (!flat.texcoords.empty()) {
                flat.texcoords[3 * kept + corner] = flat.texcoords[triangle[static_cast<int>(corner)]];
            }
        }
        flat.normals.insert(flat.normals.end(), 3, normal);
        ++kept;
    }
    flat.triangles.resize(kept);
    flat.positions.resize(3 * kept);
    if (!flat.texcoords.empty()) flat.texcoords.resize(3 * kept);
    return flat;
}

}  // namespace utsuri
