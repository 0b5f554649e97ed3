// SPDX-License-Identifier: Apache-2.0
// The tree of lights: every light at the end of its path, and within all that is said on the way of lights
// there.
#include "renderers/device_scene/light_tree.h"

#include "renderers/device_scene/light_cluster.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace utsuri {
namespace {

constexpr std::uint32_t kFirst = 3;  ///< lights that come before those of the tree

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// Lights of many sizes and powers, some in one place, some that shine everywhere.
std::vector<TreeLight> random_lights(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<TreeLight> lights;
    for (std::size_t i = 0; i < count; ++i) {
        TreeLight light;
        light.lower = 20.0 * glm::dvec3(uniform(random), uniform(random), uniform(random)) - 10.0;
        if (i % 7 == 6) light.lower = lights.back().lower;
        light.upper = light.lower;
        if (i % 5 != 0)
            light.upper += std::pow(uniform(random), 4.0) *
                           glm::dvec3(uniform(random), uniform(random), uniform(random));
        if (i % 11 != 0) light.axis = random_direction(random);
        light.both_sides = i % 3 == 0;
        light.power = std::pow(10.0, 6.0 * uniform(random));
        lights.push_back(light);
    }
    return lights;
}

struct Built {
    std::vector<TreeLight> lights;
    std::vector<interop::LightInfo> infos;
    std::vector<interop::LightTreeNode> nodes;
};

Built build(std::vector<TreeLight> lights) {
    Built built{std::move(lights), {}, {}};
    built.infos.resize(built.lights.size());
    built.nodes = build_light_tree(built.lights, built.infos, kFirst);
    return built;
}

/// The clusters on the way to a light, from the largest to that of the light alone.
std::vector<interop::LightCluster> way_to(const Built& built, std::size_t light) {
    std::vector<interop::LightCluster> way;
    std::uint32_t child = 0;
    for (std::uint32_t level = 0; level < built.infos[light].path_length; ++level) {
        EXPECT_EQ(child & interop::LIGHT_CLUSTER_LEAF, 0u);
        const interop::LightTreeNode& node = built.nodes[child & interop::LIGHT_CLUSTER_INDEX];
        way.push_back((built.infos[light].path >> level & 1u) == 0 ? node.first : node.second);
        child = way.back().child;
    }
    EXPECT_EQ(child & interop::LIGHT_CLUSTER_LEAF, interop::LIGHT_CLUSTER_LEAF);
    EXPECT_EQ(child & interop::LIGHT_CLUSTER_INDEX, kFirst + light);
    return way;
}

void expect_within(const TreeLight& light, const interop::LightCluster& cluster) {
    // A light without extent is where its position is rounded to.
    const double rounding = light.lower == light.upper ? 0x1p-24 * glm::length(light.lower) : 0.0;
    for (const glm::dvec3& corner : {light.lower, light.upper}) {
        EXPECT_LE(glm::distance(corner, glm::dvec3(cluster.centre)),
                  static_cast<double>(cluster.radius) + rounding);
    }
    if (light.both_sides) {
        EXPECT_NE(cluster.child & interop::LIGHT_CLUSTER_BOTH_SIDES, 0u);
    }
    const auto spread = static_cast<double>(cluster.cos_spread);
    if (light.axis == glm::dvec3(0.0)) {
        EXPECT_EQ(spread, -1.0);
        return;
    }
    double cosine = glm::dot(unpack_axis(cluster.axis), light.axis);
    if ((cluster.child & interop::LIGHT_CLUSTER_BOTH_SIDES) != 0) cosine = std::abs(cosine);
    // Angles are found in float64: cosines near 1 are known to some 1e-15.
    EXPECT_GE(cosine, spread - 1e-12);
}

TEST(LightTree, ClustersHoldTheirLights) {
    for (const std::size_t count : {2u, 3u, 10u, 1000u}) {
        SCOPED_TRACE(count);
        const Built built = build(random_lights(count, 5));
        EXPECT_EQ(built.nodes.size(), count - 1);
        double total = 0.0;
        for (const TreeLight& light : built.lights)
            total += light.power;
        for (std::size_t i = 0; i < count; ++i) {
            const std::vector<interop::LightCluster> way = way_to(built, i);
            for (const interop::LightCluster& cluster : way)
                expect_within(built.lights[i], cluster);
            EXPECT_NEAR(static_cast<double>(way.back().power), built.lights[i].power / total,
                        0x1p-24 * built.lights[i].power / total);
        }
        EXPECT_NEAR(static_cast<double>(built.nodes[0].first.power) +
                        static_cast<double>(built.nodes[0].second.power),
                    1.0, 1e-7);
    }
}

TEST(LightTree, OneLightIsTheFirstOfANode) {
    EXPECT_TRUE(build({}).nodes.empty());
    const Built one = build(random_lights(1, 1));
    ASSERT_EQ(one.nodes.size(), 1u);
    EXPECT_EQ(one.nodes[0].second.power, 0.0f);
    ASSERT_EQ(way_to(one, 0).size(), 1u);
    expect_within(one.lights[0], way_to(one, 0)[0]);
}

// Each light twice as far away as the one before: binned costs would peel off one at a time.
TEST(LightTree, NeverGetsTooDeep) {
    std::vector<TreeLight> lights;
    for (int i = 0; i < 400; ++i) {
        TreeLight light;
        light.lower = light.upper = glm::dvec3(std::exp2(i - 200), 0.0, 0.0);
        light.power = 1.0;
        lights.push_back(light);
    }
    const Built far = build(lights);
    for (TreeLight& light : lights)
        light.lower = light.upper = glm::dvec3(1.0);
    const Built same = build(lights);
    for (const Built* built : {&far, &same}) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            EXPECT_LE(built->infos[i].path_length, interop::LIGHT_TREE_LEVELS);
            way_to(*built, i);
        }
    }
}

// Neighbours that shine alike share their clusters.
TEST(LightTree, KeepsNeighboursTogether) {
    std::vector<TreeLight> lights;
    for (int i = 0; i < 16; ++i) {
        TreeLight light;
        light.lower = glm::dvec3(i % 2 == 0 ? 0.0 : 100.0, i, 0.0);
        light.upper = light.lower + glm::dvec3(0.5, 0.5, 0.0);
        light.axis = {0.0, 0.0, 1.0};
        light.power = 1.0;
        lights.push_back(light);
    }
    const Built built = build(lights);
    for (std::size_t i = 0; i < lights.size(); ++i)
        EXPECT_LT(way_to(built, i)[0].radius, 10.0f);
}

TEST(LightTree, ScaleDoesNotMatter) {
    std::vector<TreeLight> lights = random_lights(200, 9);
    const Built before = build(lights);
    for (TreeLight& light : lights) {
        light.lower *= 0x1p30;
        light.upper *= 0x1p30;
        light.power *= 0x1p60;
    }
    const Built after = build(lights);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        EXPECT_EQ(after.infos[i].path, before.infos[i].path);
        EXPECT_EQ(after.infos[i].path_length, before.infos[i].path_length);
    }
    for (std::size_t i = 0; i < before.nodes.size(); ++i) {
        EXPECT_EQ(after.nodes[i].first.power, before.nodes[i].first.power);
        EXPECT_EQ(after.nodes[i].first.radius, 0x1p30f * before.nodes[i].first.radius);
    }
}

// Half a step of 1 / 32767 along two coordinates of the octahedron, and one along the third, which follows
// from them; the sphere is up to sqrt(3) times as far from the middle.
TEST(LightTree, AxesArePackedClosely) {
    const double step = std::sqrt(0.25 + 0.25 + 1.0) * std::numbers::sqrt3 / 32767.0;
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 axis = random_direction(random);
        EXPECT_LE(glm::distance(unpack_axis(pack_axis(axis)), axis), step);
    }
    for (const glm::dvec3& axis :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0)})
        EXPECT_LE(glm::distance(unpack_axis(pack_axis(axis)), axis), step);
}

}  // namespace
}  // namespace utsuri
