// SPDX-License-Identifier: Apache-2.0
// Looking light up in a packed mesh, as kernels do, tells what the mesh says.
#include "renderers/light/mesh/packed_mesh.h"

#include "renderers/light/mesh/light_mesher.h"
#include "renderers/scene/scene_triangles.h"
#include "support/light_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace utsuri::test {
namespace {

glm::dvec3 from_corner(const glm::dvec3& b, std::uint32_t corner) {
    const auto at = [&](std::uint32_t i) { return b[static_cast<int>((corner + i) % 3)]; };
    return {at(0), at(1), at(2)};
}

/// Coordinates on the child of a node that is split at a share of the edge from corner 0 to 1.
glm::dvec3 on_child(const glm::dvec3& b, double share, bool second) {
    const double beyond = b.y * (1.0 - share) - b.x * share;
    return second ? glm::dvec3(b.x / (1.0 - share), beyond / (1.0 - share), b.z)
                  : glm::dvec3(-beyond / share, b.y / share, b.z);
}

double interpolated(const std::vector<interop::LightMeshPoint>& points,
                    const std::array<std::uint32_t, 3>& corners, const glm::dvec3& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += b[static_cast<int>(i)] * static_cast<double>(points[corners[i]].front.x);
    return sum;
}

double light_of(const LightMesh& mesh, std::uint32_t node, const glm::dvec3& b) {
    const MeshNode& n = mesh.nodes[node];
    if (n.split == kMeshLeaf) return interpolated(mesh.points, n.points, b);
    const glm::dvec3 turned = from_corner(b, n.split);
    const auto share = static_cast<double>(n.share);
    const bool second = turned.y * (1.0 - share) > turned.x * share;
    return light_of(mesh, n.child + (second ? 1 : 0), on_child(turned, share, second));
}

/// A part of a tree with its cuts, as a look-up comes by them.
struct Met {
    std::uint32_t leaf;
    std::uint32_t splits;
    std::vector<double> cuts;  ///< how far the place is from each, in barycentric coordinates
};

interop::LightMeshSplit split_at(const PackedMesh& mesh, std::uint32_t reference) {
    return std::bit_cast<interop::LightMeshSplit>(mesh.nodes[reference & interop::LIGHT_MESH_INDEX]);
}

Met leaf_at(const PackedMesh& mesh, std::uint32_t part, const glm::dvec2& b) {
    Met met{};
    while ((part & interop::LIGHT_MESH_LEAF) == 0) {
        const interop::LightMeshSplit split = split_at(mesh, part);
        const bool by_b2 = (split.first & interop::LIGHT_MESH_BY_B2) != 0;
        const auto slope = static_cast<double>(split.slope);
        const glm::dvec2 slopes = by_b2 ? glm::dvec2(slope, 1.0) : glm::dvec2(1.0, slope);
        const double beyond = static_cast<double>(split.constant) + slopes.x * b.x + slopes.y * b.y;
        if ((split.second & interop::LIGHT_MESH_CUT) != 0)
            met.cuts.push_back(std::abs(beyond) / (std::abs(slopes.x) + std::abs(slopes.y)));
        part = beyond > 0.0 ? split.second : split.first;
        ++met.splits;
    }
    met.leaf = part;
    return met;
}

double front_light(const PackedMesh& mesh, std::uint32_t leaf, const glm::dvec2& b) {
    if ((leaf & interop::LIGHT_MESH_FRONT) == 0) return 0.0;
    const interop::LightMeshSide& side = mesh.sides[leaf & interop::LIGHT_MESH_INDEX];
    const double light = static_cast<double>(side.constant.x) + b.x * static_cast<double>(side.along_b1.x) +
                         b.y * static_cast<double>(side.along_b2.x);
    return std::clamp(light, 0.0, static_cast<double>(side.most_red));
}

interop::LightMeshRoot root_of(const PackedMesh& mesh, std::uint32_t triangle) {
    return std::bit_cast<interop::LightMeshRoot>(mesh.nodes[triangle]);
}

/// What the grid of a triangle has at a place.
std::uint32_t part_at(const PackedMesh& mesh, const interop::LightMeshRoot& root, const glm::dvec2& b) {
    if (root.rows == 0) return root.tree;
    const auto i = std::min(static_cast<std::uint32_t>(b.x * root.rows), root.rows - 1);
    const auto j = std::min(static_cast<std::uint32_t>(b.y * root.rows), root.rows - 1 - i);
    std::uint32_t word = root.first_cell + i;
    for (std::uint32_t row = 0; row < j; ++row)
        word += root.rows - row;
    return mesh.nodes[word / 4][word % 4];
}

/// A floor, half of it lit, with a wall that is not parallel to its edges standing on it.
struct Lit {
    SceneData data;
    LightMesh mesh;
};

Lit lit_floor() {
    Scene scene;
    add(scene, quad({-2, 0, -2}, {0.3f, 0, 4}, {3.5f, 0, 0.2f}), lambert(glm::vec3(0.5f)));
    add(scene, quad({-1, 0, -0.7f}, {1.9f, 0, 1.1f}, {0, 1, 0}), lambert(glm::vec3(0.5f)));
    Lit lit{prepare_scene_data(scene), {}};
    LightMesher mesher(lit.data, {0.5, 0.02, 0.1, 100000, 1u << 24});
    while (!mesher.wanted().empty()) {
        std::vector<interop::LightMeshPoint> told;
        for (const interop::LightMeshPlace& place : mesher.wanted()) {
            const Corners c = corners_of(lit.data, place.triangle);
            const glm::dvec3 at = c[0] + static_cast<double>(place.b1) * (c[1] - c[0]) +
                                  static_cast<double>(place.b2) * (c[2] - c[0]);
            told.push_back({glm::vec3(at.x < 0.3 * at.z ? 1.0f : 0.0f), glm::vec3(0.0f)});
        }
        mesher.tell(told);
    }
    lit.mesh = mesher.finish();
    return lit;
}

constexpr int kPlaces = 4000;

glm::dvec2 random_place(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const glm::dvec2 b(uniform(random), uniform(random));
    return b.x + b.y > 1.0 ? 1.0 - b : b;
}

// Light is at most 1 on parts of no less than 1/200 of the triangle: its coefficients, of at most some times
// 200, are rounded to 2^-24. Places so near a split that rounding decides are few thousand random ones none.
TEST(PackedMesh, KeepsTheLightOfTheMesh) {
    constexpr double kRounded = 4.0 * 3.0 * 200.0 * 0x1p-24;
    const Lit lit = lit_floor();
    const auto triangles = static_cast<std::uint32_t>(lit.data.triangle_infos.size());
    const PackedMesh packed = pack(lit.mesh, triangles);
    std::mt19937 random(7);
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 b = random_place(random);
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const interop::LightMeshRoot root = root_of(packed, t);
            const std::uint32_t leaf = leaf_at(packed, part_at(packed, root, b), b).leaf;
            EXPECT_EQ(leaf, leaf_at(packed, root.tree, b).leaf) << "the grid leads elsewhere";
            EXPECT_NEAR(front_light(packed, leaf, b), light_of(lit.mesh, t, {1.0 - b.x - b.y, b.x, b.y}),
                        kRounded);
        }
    }
}

// The grid spares most of the steps down a deep tree.
TEST(PackedMesh, TakesFewStepsToALeaf) {
    const Lit lit = lit_floor();
    const PackedMesh packed = pack(lit.mesh, static_cast<std::uint32_t>(lit.data.triangle_infos.size()));
    std::mt19937 random(9);
    std::uint64_t without = 0;
    std::uint64_t with = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 b = random_place(random);
        const interop::LightMeshRoot root = root_of(packed, 0);
        ASSERT_GT(root.rows, 0u);
        without += leaf_at(packed, root.tree, b).splits;
        with += leaf_at(packed, part_at(packed, root, b), b).splits;
    }
    EXPECT_GT(without, 8u * kPlaces) << "too shallow a tree to tell";
    EXPECT_LT(2 * with, without);
}

// A cell knows every cut that passes within a cell of it: places that are known as well as that come by all
// cuts that they may lie on both sides of.
TEST(PackedMesh, KnowsCutsNearAPlace) {
    const Lit lit = lit_floor();
    const PackedMesh packed = pack(lit.mesh, static_cast<std::uint32_t>(lit.data.triangle_infos.size()));
    std::mt19937 random(8);
    std::size_t near = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 b = random_place(random);
        const interop::LightMeshRoot root = root_of(packed, 0);
        const double error = 0.999 / root.rows;
        const auto count_near = [&](const Met& met) {
            return std::count_if(met.cuts.begin(), met.cuts.end(), [&](double away) { return away < error; });
        };
        const auto all = count_near(leaf_at(packed, root.tree, b));
        EXPECT_EQ(count_near(leaf_at(packed, part_at(packed, root, b), b)), all);
        near += static_cast<std::size_t>(all);
    }
    EXPECT_GT(near, 0u);
}

}  // namespace
}  // namespace utsuri::test
