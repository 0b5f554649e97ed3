// SPDX-License-Identifier: Apache-2.0
// Looking light up in a packed mesh, as kernels do, tells what the mesh says.
#include "renderers/light/mesh/packed_mesh.h"

#include "renderers/device_scene/scene_triangles.h"
#include "renderers/light/mesh/light_mesher.h"
#include "support/light_scenes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
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
    met.leaf = part & ~interop::LIGHT_MESH_BY_B2;  // not of the leaf, but of the split that refers to it
    return met;
}

double least_of(std::uint32_t bounds) {
    return static_cast<double>(std::bit_cast<float>(bounds << 16));
}
double most_of(std::uint32_t bounds) {
    return static_cast<double>(std::bit_cast<float>(bounds & 0xffff0000u));
}

double front_light(const PackedMesh& mesh, std::uint32_t leaf, const glm::dvec2& b) {
    if ((leaf & interop::LIGHT_MESH_FRONT) == 0) return 0.0;
    const interop::LightMeshSide& side = mesh.sides[leaf & interop::LIGHT_MESH_INDEX];
    const double light = static_cast<double>(side.constant.x) + b.x * static_cast<double>(side.along_b1.x) +
                         b.y * static_cast<double>(side.along_b2.x);
    return std::clamp(light, least_of(side.red_bounds), most_of(side.red_bounds));
}

interop::LightMeshRoot root_of(const PackedMesh& mesh, std::uint32_t triangle) {
    return std::bit_cast<interop::LightMeshRoot>(mesh.nodes[triangle]);
}

/// What the grid of a triangle has at a place.
std::uint32_t part_at(const interop::LightMeshRoot& root, const glm::dvec2& b) {
    if (root.rows == 0) return root.tree;
    const auto i = std::min(static_cast<std::uint32_t>(b.x * root.rows), root.rows - 1);
    const auto j = std::min(static_cast<std::uint32_t>(b.y * root.rows), root.rows - 1 - i);
    std::uint32_t cell = root.first_cell + i;
    for (std::uint32_t row = 0; row < j; ++row)
        cell += root.rows - row;
    return cell;
}

/// A floor, half of it lit, with a wall standing on it.
struct Lit {
    SceneData data;
    LightMesh mesh;
};

Lit lit_floor(const Mesh& floor, const Mesh& wall) {
    Scene scene;
    add(scene, floor, lambert(glm::vec3(0.5f)));
    add(scene, wall, lambert(glm::vec3(0.5f)));
    Lit lit{prepare_scene_data(scene), {}};
    LightMesher mesher(lit.data, {0.5, 0.02, 0.1, 100000, 1u << 24});
    while (!mesher.wanted().empty()) {
        std::vector<interop::LightMeshPoint> told;
        for (const interop::LightMeshPlace& place : mesher.wanted()) {
            const Corners c = corners_of(lit.data, place.triangle);
            const glm::dvec3 at = c[0] + static_cast<double>(place.b1) * (c[1] - c[0]) +
                                  static_cast<double>(place.b2) * (c[2] - c[0]);
            told.push_back({glm::vec3(at.x < 0.3 * at.z ? 1.0f : 0.0f), glm::vec3(0.0f), 0, 0});
        }
        mesher.tell(told);
    }
    lit.mesh = mesher.finish();
    return lit;
}

/// With a wall that is not parallel to the edges of the floor.
Lit lit_floor() {
    return lit_floor(quad({-2, 0, -2}, {0.3f, 0, 4}, {3.5f, 0, 0.2f}),
                     quad({-1, 0, -0.7f}, {1.9f, 0, 1.1f}, {0, 1, 0}));
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
            const std::uint32_t leaf = leaf_at(packed, part_at(root, b), b).leaf;
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
        with += leaf_at(packed, part_at(root, b), b).splits;
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
        EXPECT_EQ(count_near(leaf_at(packed, part_at(root, b), b)), all);
        near += static_cast<std::size_t>(all);
    }
    EXPECT_GT(near, 0u);
}

// A place that lies beside a leaf by its error gets no more and no less than the leaf has, but for half of
// the bits of a bound.
TEST(PackedMesh, BoundsLightByWhatIsOnALeaf) {
    const Lit lit = lit_floor();
    const PackedMesh packed = pack(lit.mesh, static_cast<std::uint32_t>(lit.data.triangle_infos.size()));
    ASSERT_FALSE(packed.sides.empty());
    std::mt19937 random(10);
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 b = random_place(random);
        const std::uint32_t leaf = leaf_at(packed, root_of(packed, 0).tree, b).leaf;
        if ((leaf & interop::LIGHT_MESH_FRONT) == 0) continue;
        const interop::LightMeshSide& side = packed.sides[leaf & interop::LIGHT_MESH_INDEX];
        const double light = light_of(lit.mesh, 0, {1.0 - b.x - b.y, b.x, b.y});
        EXPECT_LE(least_of(side.red_bounds), light + 1e-9);
        EXPECT_GE(most_of(side.red_bounds), light - 1e-9);
        EXPECT_TRUE(least_of(side.red_bounds) == 0.0 || least_of(side.red_bounds) == 1.0);
        EXPECT_EQ(most_of(side.red_bounds), 1.0);
    }
}

// A wall that stands just where an edge would be halved cuts it all the same.
TEST(PackedMesh, CutsAtAWallThroughTheMiddleOfAnEdge) {
    const Lit lit =
        lit_floor(quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}), quad({0, 0, -1}, {0, 0, 2}, {0, 1, 0}));
    const PackedMesh packed = pack(lit.mesh, static_cast<std::uint32_t>(lit.data.triangle_infos.size()));
    constexpr double kNear = 1e-6;
    int asked = 0;
    for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
        const Corners c = corners_of(lit.data, triangle);
        for (const double z : {-0.73, -0.31, 0.17, 0.57}) {
            // Where the plane x = 0 passes through the triangle at this z.
            const glm::dmat2 edges(c[1].x - c[0].x, c[1].z - c[0].z, c[2].x - c[0].x, c[2].z - c[0].z);
            const glm::dvec2 b = glm::inverse(edges) * (glm::dvec2(0, z) - glm::dvec2(c[0].x, c[0].z));
            if (b.x < 0.0 || b.y < 0.0 || b.x + b.y > 1.0) continue;
            const std::vector<double> cuts = leaf_at(packed, root_of(packed, triangle).tree, b).cuts;
            EXPECT_TRUE(std::any_of(cuts.begin(), cuts.end(), [](double away) { return away < kNear; }));
            ++asked;
        }
    }
    EXPECT_EQ(asked, 4);
}

}  // namespace
}  // namespace utsuri::test
