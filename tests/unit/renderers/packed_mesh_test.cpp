// SPDX-License-Identifier: Apache-2.0
// Looking light up in a packed mesh, as kernels do, tells what the mesh says.
#include "renderers/light/mesh/packed_mesh.h"

#include "renderers/light/mesh/light_mesher.h"
#include "renderers/scene/scene_triangles.h"
#include "support/light_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace utsuri::test {
namespace {

/// Bits of LightMeshNode::head.
std::uint32_t field(std::uint32_t head, std::uint32_t at, std::uint32_t bits) {
    return (head >> at) & ((1u << bits) - 1u);
}

constexpr std::uint32_t kHalvingsAt = interop::LIGHT_MESH_KIND_BITS + interop::LIGHT_MESH_CORNER_BITS;
constexpr std::uint32_t kChildAt = kHalvingsAt + interop::LIGHT_MESH_HALVINGS_BITS;

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

/// A node of a packed mesh that is cut, and what tells its children apart.
struct Cut {
    std::uint32_t node;
    double beyond;
};

double light_of(const PackedMesh& mesh, std::uint32_t root, glm::dvec3 b, std::vector<Cut>& cuts) {
    std::uint32_t index = root;
    for (;;) {
        const interop::LightMeshNode& n = mesh.nodes[index];
        const std::uint32_t kind = field(n.head, 0, interop::LIGHT_MESH_KIND_BITS);
        if (kind == interop::LIGHT_MESH_LEAF)
            return interpolated(mesh.points, {n.first, n.second, n.third}, b);
        b = from_corner(b, field(n.head, interop::LIGHT_MESH_KIND_BITS, interop::LIGHT_MESH_CORNER_BITS));
        index = n.head >> kChildAt;
        if (kind == interop::LIGHT_MESH_CUT) {
            const auto share = static_cast<double>(std::bit_cast<float>(n.first));
            const double beyond = b.y * (1.0 - share) - b.x * share;
            cuts.push_back({static_cast<std::uint32_t>(&n - mesh.nodes.data()), beyond});
            index += beyond > 0.0 ? 1 : 0;
            b = on_child(b, share, beyond > 0.0);
            continue;
        }
        std::uint32_t part = 0;
        const std::uint32_t halvings = field(n.head, kHalvingsAt, interop::LIGHT_MESH_HALVINGS_BITS);
        for (std::uint32_t i = 0; i < halvings; ++i) {
            const bool second = b.y > b.x;
            const glm::dvec3 child = on_child(b, 0.5, second);
            // Counted from the edge that the split point looks at.
            b = from_corner(child, second ? 1 : 2);
            part = 2 * part + (second ? 1 : 0);
        }
        index += part;
    }
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

// Nodes and coordinates of both are doubles here: they differ by roundings alone, but for a place so near a
// split that these decide, of which a few thousand random ones hold none.
TEST(PackedMesh, KeepsTheLightOfTheMesh) {
    const Lit lit = lit_floor();
    const auto triangles = static_cast<std::uint32_t>(lit.data.triangle_infos.size());
    const PackedMesh packed = pack(lit.mesh, triangles);
    EXPECT_LT(packed.nodes.size(), lit.mesh.nodes.size());
    EXPECT_EQ(packed.points.size(), lit.mesh.points.size());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::size_t cuts_met = 0;
    for (int i = 0; i < kPlaces; ++i) {
        glm::dvec2 b(uniform(random), uniform(random));
        if (b.x + b.y > 1.0) b = 1.0 - b;
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const glm::dvec3 place(1.0 - b.x - b.y, b.x, b.y);
            std::vector<Cut> cuts;
            EXPECT_NEAR(light_of(packed, t, place, cuts), light_of(lit.mesh, t, place), 1e-9);
            cuts_met += cuts.size();
        }
    }
    EXPECT_GT(cuts_met, 0u);
}

// Beside each place, what tells the children of a cut apart is off by as much as the cut says: linear, so
// that differences of doubles a millionth apart tell it to 2^-52 / 1e-6, and float32 to its rounding.
TEST(PackedMesh, SaysHowFarAPlaceIsFromACut) {
    const Lit lit = lit_floor();
    const PackedMesh packed = pack(lit.mesh, static_cast<std::uint32_t>(lit.data.triangle_infos.size()));
    std::mt19937 random(8);
    std::uniform_real_distribution<double> uniform(0.05, 0.45);
    constexpr double kStep = 1e-6;
    int compared = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 b(uniform(random), uniform(random));
        std::vector<Cut> here;
        light_of(packed, 0, {1.0 - b.x - b.y, b.x, b.y}, here);
        for (int axis = 0; axis < 2; ++axis) {
            glm::dvec2 moved = b;
            moved[axis] += kStep;
            std::vector<Cut> there;
            light_of(packed, 0, {1.0 - moved.x - moved.y, moved.x, moved.y}, there);
            for (std::size_t k = 0; k < std::min(here.size(), there.size()) && here[k].node == there[k].node;
                 ++k) {
                const interop::LightMeshNode& cut = packed.nodes[here[k].node];
                const auto told =
                    static_cast<double>(std::bit_cast<float>(axis == 0 ? cut.second : cut.third));
                const double measured = std::abs(there[k].beyond - here[k].beyond) / kStep;
                EXPECT_NEAR(measured, told, 1e-6 * std::max(told, 1.0)) << k;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, kPlaces / 2);
}

}  // namespace
}  // namespace utsuri::test
