// SPDX-License-Identifier: Apache-2.0
#include "support/triangle_soup.h"

#include "base/sampler.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

/// A random point of the cube [-1, 1]^3.
glm::vec3 random_point(std::uint32_t index, std::uint32_t seed) {
    const glm::vec2 xy = sample_2d(seed, index, 0);
    return 2.0f * glm::vec3(xy, sample_2d(seed, index, 1).x) - 1.0f;
}

}  // namespace

void TriangleSoup::add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.emplace_back(first, first + 1, first + 2);
}

TriangleSoup random_soup(std::uint32_t count, float size, std::uint32_t seed) {
    TriangleSoup soup;
    soup.positions.reserve(std::size_t{3} * count);
    soup.triangles.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 centre = random_point(4 * i, seed);
        const auto corner = [&](std::uint32_t k) {
            return centre + 0.5f * size * random_point(4 * i + k, seed);
        };
        soup.add(corner(1), corner(2), corner(3));
    }
    return soup;
}

TriangleSoup flat_grid(std::uint32_t n, int axis) {
    TriangleSoup soup;
    const auto point = [&](std::uint32_t i, std::uint32_t j) {
        const auto coordinate = [n](std::uint32_t k) {
            return 2.0f * static_cast<float>(k) / static_cast<float>(n) - 1.0f;
        };
        glm::vec3 result(0.0f);
        result[(axis + 1) % 3] = coordinate(i);
        result[(axis + 2) % 3] = coordinate(j);
        return result;
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            soup.add(point(i, j), point(i + 1, j), point(i + 1, j + 1));
            soup.add(point(i, j), point(i + 1, j + 1), point(i, j + 1));
        }
    }
    return soup;
}

TriangleSoup nested_soup(std::uint32_t count) {
    TriangleSoup soup;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float size = std::ldexp(1.0f, -static_cast<int>(i));
        soup.add({size, 0.0f, 0.0f}, {0.0f, size, 0.0f}, {0.0f, 0.0f, size});
    }
    return soup;
}

Mesh to_mesh(const TriangleSoup& soup) {
    Mesh mesh;
    for (const glm::uvec3& triangle : soup.triangles) {
        const glm::vec3& a = soup.positions[triangle.x];
        const glm::vec3& b = soup.positions[triangle.y];
        const glm::vec3& c = soup.positions[triangle.z];
        const glm::dvec3 normal = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
        const double length = glm::length(normal);
        const glm::vec3 unit = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {a, b, c});
        mesh.normals.insert(mesh.normals.end(), 3, unit);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
}

TriangleSoup to_soup(const Mesh& mesh) {
    return {mesh.positions, mesh.triangles};
}

TriangleSoup scaled(TriangleSoup soup, float factor) {
    for (glm::vec3& position : soup.positions)
        position *= factor;
    return soup;
}

}  // namespace utsuri::test
