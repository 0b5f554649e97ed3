// SPDX-License-Identifier: Apache-2.0
#include "support/light_scenes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri::test {

Mesh ground(float half) {
    return quad({-half, 0, half}, {2 * half, 0, 0}, {0, 0, -2 * half});
}

Mesh triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.normals.assign(3, glm::normalize(glm::cross(b - a, c - a)));
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

Mesh flipped(Mesh mesh) {
    for (glm::vec3& normal : mesh.normals)
        normal = -normal;
    for (glm::uvec3& corners : mesh.triangles)
        std::swap(corners.y, corners.z);
    return mesh;
}

Mesh faceted(const Mesh& mesh) {
    Mesh result;
    for (const glm::uvec3& corners : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(result.positions.size());
        const glm::vec3 a = mesh.positions[corners.x];
        const glm::vec3 b = mesh.positions[corners.y];
        const glm::vec3 c = mesh.positions[corners.z];
        result.positions.insert(result.positions.end(), {a, b, c});
        result.normals.insert(result.normals.end(), 3, glm::normalize(glm::cross(b - a, c - a)));
        result.triangles.emplace_back(first, first + 1, first + 2);
    }
    return result;
}

Mesh block(glm::vec3 lower, glm::vec3 upper) {
    return flipped(room(lower, upper));
}

Mesh ceiling(glm::vec3 centre, float half) {
    return quad(centre - glm::vec3(half, 0, half), {2 * half, 0, 0}, {0, 0, 2 * half});
}

double polygon_irradiance(std::span<const glm::dvec3> corners, const glm::dvec3& point,
                          const glm::dvec3& normal) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - point;
        const glm::dvec3 b = corners[(i + 1) % corners.size()] - point;
        const glm::dvec3 edge_normal = glm::cross(b, a);
        const double sine = glm::length(edge_normal);
        sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(edge_normal / sine, normal);
    }
    return 0.5 * sum;
}

}  // namespace utsuri::test
