// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/triangles.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace utsuri {
namespace {

bool is_finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class Vector>
void gather(std::vector<Vector>& values, std::span<const std::uint32_t> kept) {
    if (values.empty()) return;
    // The kept indices ascend, so no value is overwritten before it is read.
    for (std::size_t i = 0; i < kept.size(); ++i)
        values[i] = values[kept[i]];
    values.resize(kept.size());
}

}  // namespace

std::vector<glm::uvec3> assemble_triangles(Topology topology, std::span<const std::uint32_t> indices) {
    std::vector<glm::uvec3> triangles;
    const std::size_t count = indices.size();
    if (topology == Topology::triangles) {
        triangles.reserve(count / 3);
        for (std::size_t i = 0; i + 2 < count; i += 3) {
            triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
        }
        return triangles;
    }
    if (count < 3) return triangles;
    triangles.reserve(count - 2);
    for (std::size_t i = 0; i + 2 < count; ++i) {
        if (topology == Topology::triangle_strip) {
            // Every second triangle is turned round to keep its front.
            triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
        } else {
            triangles.emplace_back(indices[i + 1], indices[i + 2], indices[0]);
        }
    }
    return triangles;
}

glm::dvec3 edge_cross(const Mesh& mesh, glm::uvec3 triangle) {
    const glm::dvec3 a(mesh.positions[triangle.x]);
    return glm::cross(glm::dvec3(mesh.positions[triangle.y]) - a, glm::dvec3(mesh.positions[triangle.z]) - a);
}

DroppedTriangles drop_undrawable(Mesh& mesh) {
    DroppedTriangles dropped;
    std::size_t kept = 0;
    for (const glm::uvec3 triangle : mesh.triangles) {
        const bool finite = is_finite(mesh.positions[triangle.x]) && is_finite(mesh.positions[triangle.y]) &&
                            is_finite(mesh.positions[triangle.z]);
        if (!finite) {
            ++dropped.non_finite;
        } else if (edge_cross(mesh, triangle) == glm::dvec3(0.0)) {
            ++dropped.zero_area;
        } else {
            mesh.triangles[kept++] = triangle;
        }
    }
    mesh.triangles.resize(kept);
    return dropped;
}

void drop_unused_vertices(Mesh& mesh) {
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> new_index(mesh.positions.size(), kUnused);
    for (const glm::uvec3 triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner)
            new_index[triangle[corner]] = 0;
    }
    std::vector<std::uint32_t> kept;
    kept.reserve(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < new_index.size(); ++vertex) {
        if (new_index[vertex] == kUnused) continue;
        new_index[vertex] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(static_cast<std::uint32_t>(vertex));
    }
    if (kept.size() == mesh.positions.size()) return;
    gather(mesh.positions, kept);
    gather(mesh.normals, kept);
    gather(mesh.texcoords, kept);
    for (glm::uvec3& triangle : mesh.triangles) {
        triangle = {new_index[triangle.x], new_index[triangle.y], new_index[triangle.z]};
    }
}

}  // namespace utsuri
