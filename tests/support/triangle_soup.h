// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri::test {

/// Indexed triangles without anything else, as the BVH builder takes them.
struct TriangleSoup {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
};

/// Triangles with corners within `size` / 2 of centres that are uniform in the cube [-1, 1]^3.
TriangleSoup random_soup(std::uint32_t count, float size, std::uint32_t seed = 1);

/// n x n squares of two triangles each in the plane where `axis` is 0, reaching from -1 to 1.
TriangleSoup flat_grid(std::uint32_t n, int axis);

/// Triangles of edge 2^-i around the origin, i = 0 .. count - 1: the centroids nest exponentially.
TriangleSoup nested_soup(std::uint32_t count);

/// A mesh of these triangles with a normal per triangle.
Mesh to_mesh(const TriangleSoup& soup);
TriangleSoup to_soup(const Mesh& mesh);

/// All lengths times `factor`.
TriangleSoup scaled(TriangleSoup soup, float factor);

}  // namespace utsuri::test
