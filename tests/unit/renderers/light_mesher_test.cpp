// SPDX-License-Identifier: Apache-2.0
// Meshes over triangles, grown by light that the tests make up.
#include "renderers/light/mesh/light_mesher.h"

#include "renderers/device_scene/scene_triangles.h"
#include "support/light_scenes.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace utsuri::test {
namespace {

using Light = std::function<float(const glm::dvec3& world)>;

struct Leaf {
    std::uint32_t triangle;
    Corners corners;  ///< scene space
    std::array<std::uint32_t, 3> points;
};

struct Made {
    SceneData data;
    LightMesh mesh;
    std::vector<Leaf> leaves;
    std::size_t asked = 0;

    void collect(std::uint32_t node, std::uint32_t triangle, const Corners& corners) {
        const MeshNode& n = mesh.nodes[node];
        if (n.split == kMeshLeaf) {
            if (n.points[0] != interop::NONE) leaves.push_back({triangle, corners, n.points});
            return;
        }
        const glm::dvec3 a = corners[n.split];
        const glm::dvec3 b = corners[(n.split + 1) % 3];
        const glm::dvec3 c = corners[(n.split + 2) % 3];
        const glm::dvec3 p = glm::mix(a, b, static_cast<double>(n.share));
        collect(n.child, triangle, {a, p, c});
        collect(n.child + 1, triangle, {p, b, c});
    }
};

Made make(const Scene& scene, const MeshSettings& settings, const Light& light) {
    Made made;
    made.data = prepare_scene_data(scene);
    LightMesher mesher(made.data, settings);
    while (!mesher.wanted().empty()) {
        std::vector<interop::LightMeshPoint> told;
        for (const interop::LightMeshPlace& place : mesher.wanted()) {
            const Corners corners = corners_of(made.data, place.triangle);
            const glm::dvec3 at = corners[0] + static_cast<double>(place.b1) * (corners[1] - corners[0]) +
                                  static_cast<double>(place.b2) * (corners[2] - corners[0]);
            told.push_back({glm::vec3(light(made.data.origin + at)), glm::vec3(0.0f), 0, 0});
        }
        made.asked += told.size();
        mesher.tell(told);
    }
    made.mesh = mesher.finish();
    for (std::uint32_t t = 0; t < made.data.triangle_infos.size(); ++t)
        made.collect(t, t, corners_of(made.data, t));
    return made;
}

double longest_edge(const Corners& c) {
    return std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
}

float even(const glm::dvec3& /*world*/) {
    return 1.0f;
}

/// Lit where x < 0.3 z.
float half_lit(const glm::dvec3& world) {
    return world.x < 0.3 * world.z ? 1.0f : 0.0f;
}

Scene floor_of(float size) {
    Scene scene;
    add(scene, quad({-size, 0, -size}, {0, 0, 2 * size}, {2 * size, 0, 0}), lambert(glm::vec3(0.5f)));
    return scene;
}

constexpr std::uint64_t kRoom = 1u << 24;
constexpr MeshSettings kSettings{0.5, 0.05, 0.1, 100000, kRoom};

TEST(LightMesher, KeepsPointsWithinTheCoarsestDistanceAndNoDenserWhereLightIsEven) {
    const Made made = make(floor_of(2.0f), kSettings, even);
    for (const Leaf& leaf : made.leaves) {
        EXPECT_LE(longest_edge(leaf.corners), 0.5 * (1.0 + 1e-6));
        EXPECT_GT(longest_edge(leaf.corners), 0.25);
    }
}

// Between two places on one side of a straight line all places are on that side.
TEST(LightMesher, ExpectsWhatBothEndsOfAnEdgeAgreeOn) {
    const SceneData data = prepare_scene_data(floor_of(2.0f));
    LightMesher mesher(data, kSettings);
    int lit = 0;
    int dark = 0;
    int unsure = 0;
    for (bool is_first = true; !mesher.wanted().empty(); is_first = false) {
        std::vector<interop::LightMeshPoint> told;
        for (const interop::LightMeshPlace& place : mesher.wanted()) {
            const Corners corners = corners_of(data, place.triangle);
            const glm::dvec3 at = corners[0] + static_cast<double>(place.b1) * (corners[1] - corners[0]) +
                                  static_cast<double>(place.b2) * (corners[2] - corners[0]);
            const float light = half_lit(data.origin + at);
            const std::uint32_t bit = light > 0.0f ? 1 : 0;
            told.push_back({glm::vec3(light), glm::vec3(0.0f), bit, 1 - bit});
            EXPECT_LE(place.lit, bit);
            EXPECT_LE(place.dark, 1 - bit);
            EXPECT_TRUE(!is_first || (place.lit | place.dark) == 0u);
            lit += static_cast<int>(place.lit);
            dark += static_cast<int>(place.dark);
            if (place.lit + place.dark == 0) ++unsure;
        }
        mesher.tell(told);
    }
    EXPECT_GT(lit, 20);
    EXPECT_GT(dark, 20);
    EXPECT_GT(unsure, 20);
}

TEST(LightMesher, RefinesWhereLightEndsAndNowhereElse) {
    const Made made = make(floor_of(2.0f), kSettings, half_lit);
    for (const Leaf& leaf : made.leaves) {
        std::set<float> light;
        double nearest = 1e9;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 world = made.data.origin + leaf.corners[i];
            light.insert(half_lit(world));
            nearest = std::min(nearest, std::abs(world.x - 0.3 * world.z));
        }
        if (light.size() > 1) {
            EXPECT_LE(longest_edge(leaf.corners), 0.05 * (1.0 + 1e-6));
        }
        if (nearest > 1.0) {
            EXPECT_GT(longest_edge(leaf.corners), 0.2);
        }
    }
    // An edge of 4 m in leaves of 5 cm, against 80 x 80 squares of two leaves each.
    EXPECT_LT(made.leaves.size(), 12800u / 4);
}

TEST(LightMesher, LeavesNoPointInTheMiddleOfANeighboursEdge) {
    const Made made = make(floor_of(2.0f), kSettings, half_lit);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Leaf> users;
    for (const Leaf& leaf : made.leaves) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::pair<std::uint32_t, std::uint32_t> edge =
                std::minmax(leaf.points[i], leaf.points[(i + 1) % 3]);
            ++uses[edge];
            users[edge] = leaf;
        }
    }
    for (const auto& [edge, count] : uses) {
        if (count == 2) continue;
        EXPECT_EQ(count, 1);
        // Only at the rim.
        int at_rim = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Leaf& leaf = users[edge];
            if (leaf.points[i] != edge.first && leaf.points[i] != edge.second) continue;
            const glm::dvec3 world = made.data.origin + leaf.corners[i];
            if (std::max(std::abs(world.x), std::abs(world.z)) > 2.0 - 1e-6) ++at_rim;
        }
        EXPECT_EQ(at_rim, 2);
    }
}

// A slat of 2 m by 1 cm, 5 halvings: each makes three leaves of one, whose other long edge is halved, too.
TEST(LightMesher, SpendsLittleOnTheWidthOfSlats) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {2, 0, 0}, {0, 0.01f, 0}), lambert(glm::vec3(0.5f)));
    const Made made = make(scene, {0.07, 0.07, 0.1, 100000, kRoom}, even);
    for (const Leaf& leaf : made.leaves)
        EXPECT_LE(longest_edge(leaf.corners), 0.07);
    EXPECT_LE(made.leaves.size(), 2u * 243u);
}

TEST(LightMesher, KeepsWithinItsPoints) {
    const std::size_t coarse = make(floor_of(2.0f), {0.5, 0.5, 0.1, 0, kRoom}, half_lit).mesh.points.size();
    for (const std::uint64_t most : {std::uint64_t{0}, std::uint64_t{100}, std::uint64_t{1000}}) {
        const Made made = make(floor_of(2.0f), {0.5, 0.001, 0.1, most, kRoom}, half_lit);
        // Splits that follow a neighbour's are made whatever it takes.
        EXPECT_LE(made.asked, coarse + most + most / 4);
        EXPECT_GE(made.asked, coarse + most);
    }
    for (const std::uint64_t room : {std::uint64_t{4}, std::uint64_t{100}}) {
        EXPECT_LE(make(floor_of(2.0f), {0.02, 0.001, 0.1, 1000, room}, half_lit).asked, room);
    }
}

TEST(LightMesher, PassesOverWhatReflectsNothingDiffuselyAndWhatHasNoArea) {
    Scene scene = floor_of(1.0f);
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    add(scene, ceiling({0, 2, 0}, 0.5f), mirror());
    Mesh mesh;
    mesh.positions.assign(3, glm::vec3(1, 2, 3));
    mesh.normals.assign(3, glm::vec3(0, 0, 1));
    mesh.triangles = {{0, 1, 2}};
    add(scene, mesh, lambert(glm::vec3(0.5f)));
    const Made made = make(scene, kSettings, even);
    ASSERT_FALSE(made.leaves.empty());
    for (const Leaf& leaf : made.leaves)
        EXPECT_EQ(made.data.triangle_infos[leaf.triangle].instance, 0u);
}

TEST(LightMesher, SharesPointsOfSmoothMeshesOnly) {
    Scene scene;
    add(scene, icosphere({0, 1, 0}, 0.5f, 2), lambert(glm::vec3(0.5f)));
    const Made made = make(scene, {10.0, 10.0, 0.1, 100000, kRoom}, even);
    EXPECT_EQ(made.mesh.points.size(), made.data.normals.size());
}

/// A floor, and a wall across it that stands on it, turned off all axes.
Scene parted_floor(const Mesh& wall) {
    Scene scene = floor_of(2.0f);
    add(scene, wall, lambert(glm::vec3(0.5f)));
    const glm::dmat4 slanted =
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, -0.7, 0.2)), 0.7, glm::dvec3(1, 2, 3));
    for (Instance& instance : scene.instances)
        instance.world_from_object = slanted;
    return scene;
}

// Of a wall's two sides one is lit: whatever lies between the points of a leaf has light of one side alone.
TEST(LightMesher, InterpolatesNothingAcrossAWall) {
    const Mesh thin = block({-3, 0, 0.1f}, {3, 1, 0.102f});
    const Mesh sunk = block({-3, -0.5f, 0.1f}, {3, 1, 0.3f});
    const Mesh sheet = quad({-1.9f, 0, 0.1f}, {3.8f, 0, 0.2f}, {0, 1, 0});
    for (const Mesh& wall : {thin, sunk, sheet}) {
        const Scene scene = parted_floor(wall);
        const glm::dmat4 upright = glm::inverse(scene.instances[0].world_from_object);
        const bool is_sheet = wall.triangles.size() == 2;
        const Light lit_in_front = [&](const glm::dvec3& world) {
            const glm::dvec3 at(upright * glm::dvec4(world, 1.0));
            const double wall_z = is_sheet ? 0.1 + (at.x + 1.9) * 0.2 / 3.8 : 0.1;
            return at.z < wall_z ? 1.0f : 0.0f;
        };
        const Made made = make(scene, kSettings, lit_in_front);
        int beside = 0;
        for (const Leaf& leaf : made.leaves) {
            if (made.data.triangle_infos[leaf.triangle].instance != 0) continue;
            const glm::dvec3 middle = (leaf.corners[0] + leaf.corners[1] + leaf.corners[2]) / 3.0;
            const glm::dvec3 at(upright * glm::dvec4(made.data.origin + middle, 1.0));
            // Beyond the ends of the sheet there is nothing that parts light.
            if (is_sheet && std::abs(at.x) > 1.8) continue;
            const float light = lit_in_front(made.data.origin + middle);
            for (const std::uint32_t point : leaf.points)
                EXPECT_EQ(made.mesh.points[point].front.x, light) << at.x << ' ' << at.z;
            if (std::abs(at.z - 0.1) < 0.3) ++beside;
        }
        EXPECT_GT(beside, 10);
    }
}

}  // namespace
}  // namespace utsuri::test
