// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh.h"

#include "support/scenes.h"
#include "support/triangle_soup.h"

#include "base/check.h"
#include "geometry/binary_bvh.h"
#include "geometry/bounds.h"
#include "geometry/bvh_check.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

namespace utsuri {
namespace {

using test::TriangleSoup;

struct Input {
    std::string name;
    TriangleSoup soup;
};

TriangleSoup one_triangle() {
    TriangleSoup soup;
    soup.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return soup;
}

TriangleSoup identical_triangles() {
    TriangleSoup soup;
    for (int i = 0; i < 1000; ++i)
        soup.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f});
    return soup;
}

TriangleSoup collinear_centroids() {
    TriangleSoup soup;
    for (int i = 0; i < 5000; ++i) {
        const auto x = static_cast<float>(i);
        soup.add({x, -1, -1}, {x, 1, -1}, {x, 0, 2});
    }
    return soup;
}

/// Concentric triangles: all centroids in one point, boxes of 1000 sizes.
TriangleSoup concentric_triangles() {
    TriangleSoup soup;
    for (int i = 1; i <= 1000; ++i) {
        const auto r = static_cast<float>(i);
        soup.add({-r, -r, 0}, {r, -r, 0}, {0, r, 0});
    }
    return soup;
}

TriangleSoup huge_ground_and_tiny_objects() {
    TriangleSoup soup = test::scaled(test::random_soup(5000, 0.1f), 1e-3f);
    soup.add({-1e6f, -1e-3f, -1e6f}, {1e6f, -1e-3f, -1e6f}, {0, -1e-3f, 1e6f});
    return soup;
}

TriangleSoup zero_area_triangles() {
    TriangleSoup soup = test::random_soup(500, 0.1f);
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 p = soup.positions[static_cast<std::size_t>(3 * i)];
        const glm::vec3 q = soup.positions[static_cast<std::size_t>(3 * i + 1)];
        soup.add(p, p, p);
        soup.add(p, q, q);
        soup.add(p, 0.5f * (p + q), q);
    }
    return soup;
}

std::vector<Input> inputs() {
    const TriangleSoup random = test::random_soup(20000, 0.05f);
    return {{"none", {}},
            {"one", one_triangle()},
            {"four", test::random_soup(4, 0.5f)},
            {"random", random},
            {"identical", identical_triangles()},
            {"collinear", collinear_centroids()},
            {"concentric", concentric_triangles()},
            {"nested", test::nested_soup(120)},
            {"nested_copies",
             [] {
                 TriangleSoup soup = test::nested_soup(60);
                 for (int copy = 0; copy < 20; ++copy) {
                     for (int i = 0; i < 60; ++i) {
                         const auto at = static_cast<std::size_t>(3 * i);
                         soup.add(soup.positions[at], soup.positions[at + 1], soup.positions[at + 2]);
                     }
                 }
                 return soup;
             }()},
            {"ground_and_dust", huge_ground_and_tiny_objects()},
            {"zero_area", zero_area_triangles()},
            {"grid_x", test::flat_grid(50, 0)},
            {"grid_y", test::flat_grid(50, 1)},
            {"grid_z", test::flat_grid(50, 2)},
            {"sphere", test::to_soup(test::icosphere(glm::vec3(0.0f), 1.0f, 4))},
            {"million_metres", test::scaled(random, 1e6f)},
            {"micrometres", test::scaled(random, 1e-6f)},
            {"largest_floats", test::scaled(random, 1e18f)},
            {"smallest_floats", test::scaled(random, 1e-30f)}};
}

bool same_bytes(const auto& a, const auto& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

class BvhOf : public testing::TestWithParam<Input> {};

TEST_P(BvhOf, PassesTheChecker) {
    const TriangleSoup& soup = GetParam().soup;
    const Bvh bvh = build_bvh(soup.positions, soup.triangles);
    EXPECT_EQ(check_bvh(bvh, soup.triangles.size()), "");
    EXPECT_LE(bvh.depth, interop::BVH_MAX_DEPTH);
}

TEST_P(BvhOf, HoldsTheInputsVertices) {
    const TriangleSoup& soup = GetParam().soup;
    const Bvh bvh = build_bvh(soup.positions, soup.triangles);
    ASSERT_EQ(bvh.order.size(), soup.triangles.size());
    for (std::size_t i = 0; i < bvh.order.size(); ++i) {
        const glm::uvec3& input = soup.triangles[bvh.order[i]];
        ASSERT_EQ(bvh.triangles[i].v0, soup.positions[input.x]);
        ASSERT_EQ(bvh.triangles[i].v1, soup.positions[input.y]);
        ASSERT_EQ(bvh.triangles[i].v2, soup.positions[input.z]);
    }
}

/// Holds each child box against the true bounds of what is below it.
class BoxComparison {
  public:
    explicit BoxComparison(const Bvh& bvh) : bvh_(bvh) {}

    Bounds visit(std::uint32_t index) {
        const interop::BvhNode& node = bvh_.nodes[index];
        Bounds all;
        for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH; ++slot) {
            const SlotContent content = slot_content(node, slot);
            Bounds bounds;
            if (content.is_node) bounds = visit(content.node);
            for (std::uint32_t i = 0; i < content.triangle_count; ++i) {
                const interop::BvhTriangle& triangle = bvh_.triangles[content.first_triangle + i];
                for (const glm::vec3& vertex : {triangle.v0, triangle.v1, triangle.v2})
                    bounds.extend(vertex);
            }
            if (!bounds.empty()) compare(node, child_box(node, slot), bounds);
            all.extend(bounds);
        }
        return all;
    }

  private:
    static void compare(const interop::BvhNode& node, const ChildBox& box, const Bounds& bounds) {
        for (int axis = 0; axis < 3; ++axis) {
            const int exponent = static_cast<int>((node.origin_exponents.w >> (8 * axis)) & 0xffu) - 127;
            const double cell = std::ldexp(1.0, exponent);
            const double lower_gap = static_cast<double>(bounds.lower[axis]) - box.lower[axis];
            const double upper_gap = box.upper[axis] - static_cast<double>(bounds.upper[axis]);
            EXPECT_GE(lower_gap, 0.0);
            EXPECT_GE(upper_gap, 0.0);
            // Rounding outwards to the grid adds less than a cell; a step for the rounding of differences,
            // one more.
            EXPECT_LE(lower_gap, 2.0 * cell);
            EXPECT_LE(upper_gap, 2.0 * cell);
        }
    }

    const Bvh& bvh_;
};

TEST_P(BvhOf, HasBoxesThatContainTheirContentAndExceedItByACell) {
    const TriangleSoup& soup = GetParam().soup;
    const Bvh bvh = build_bvh(soup.positions, soup.triangles);
    BoxComparison(bvh).visit(0);
}

TEST_P(BvhOf, RefittedWhereItIsChangesNothing) {
    const TriangleSoup& soup = GetParam().soup;
    const Bvh bvh = build_bvh(soup.positions, soup.triangles);
    Bvh refitted = bvh;
    refit(refitted, soup.positions, soup.triangles);
    EXPECT_TRUE(same_bytes(refitted.nodes, bvh.nodes));
    EXPECT_TRUE(same_bytes(refitted.triangles, bvh.triangles));
}

TEST_P(BvhOf, RefittedToOtherPlacesPassesTheChecker) {
    const TriangleSoup& soup = GetParam().soup;
    TriangleSoup moved = soup;
    // Turned about, and every other vertex pulled towards the middle.
    for (std::size_t i = 0; i < moved.positions.size(); ++i) {
        glm::vec3& position = moved.positions[i];
        position = (i % 2 == 0 ? 1.0f : 0.25f) * glm::vec3(position.z, -position.x, position.y);
    }
    Bvh bvh = build_bvh(soup.positions, soup.triangles);
    const std::vector<std::uint32_t> order = bvh.order;
    refit(bvh, moved.positions, moved.triangles);
    EXPECT_EQ(check_bvh(bvh, soup.triangles.size()), "");
    EXPECT_EQ(bvh.order, order);
    for (std::size_t i = 0; i < bvh.order.size(); ++i)
        ASSERT_EQ(bvh.triangles[i].v1, moved.positions[moved.triangles[bvh.order[i]].y]);
}

// Steps make anew only what is above triangles that they move; from the start, all is.
TEST_P(BvhOf, RefittedStepByStepIsAsRefittedAtOnce) {
    const TriangleSoup& soup = GetParam().soup;
    const Bvh built = build_bvh(soup.positions, soup.triangles);
    TriangleSoup moved = soup;
    Bvh stepwise = built;
    std::mt19937 random(11);
    for (int step = 0; step < 6; ++step) {
        const std::size_t count = moved.positions.empty() || step == 3 ? 0 : 1 + moved.positions.size() / 200;
        for (std::size_t i = 0; i < count; ++i) {
            glm::vec3& position = moved.positions[random() % moved.positions.size()];
            position = {position.y, position.z, 0.5f * position.x};
        }
        refit(stepwise, moved.positions, moved.triangles);
        Bvh at_once = built;
        refit(at_once, moved.positions, moved.triangles);
        ASSERT_TRUE(same_bytes(stepwise.nodes, at_once.nodes)) << "step " << step;
        ASSERT_TRUE(same_bytes(stepwise.triangles, at_once.triangles)) << "step " << step;
    }
    EXPECT_EQ(check_bvh(stepwise, soup.triangles.size()), "");
}

INSTANTIATE_TEST_SUITE_P(Inputs, BvhOf, testing::ValuesIn(inputs()),
                         [](const testing::TestParamInfo<Input>& input) { return input.param.name; });

TEST(Bvh, IsTheSameOnEveryBuild) {
    // Enough triangles for several threads to take part.
    const TriangleSoup soup = test::random_soup(200000, 0.01f);
    const Bvh first = build_bvh(soup.positions, soup.triangles);
    const Bvh second = build_bvh(soup.positions, soup.triangles);
    EXPECT_EQ(check_bvh(first, soup.triangles.size()), "");
    EXPECT_TRUE(same_bytes(first.nodes, second.nodes));
    EXPECT_TRUE(same_bytes(first.order, second.order));
}

// Scaling by a power of two changes nothing but the grids: their origins scale, their exponents shift.
void expect_scaled_nodes(const Bvh& bvh, const Bvh& scaled, int k) {
    ASSERT_EQ(scaled.nodes.size(), bvh.nodes.size());
    constexpr std::uint32_t kFlatExponent = 1;  // the smallest normal cell, for axes without extent
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const interop::BvhNode& a = bvh.nodes[i];
        const interop::BvhNode& b = scaled.nodes[i];
        ASSERT_EQ(b.bases_meta, a.bases_meta);
        ASSERT_EQ(b.lower_xy, a.lower_xy);
        ASSERT_EQ(b.lower_z_upper_x, a.lower_z_upper_x);
        ASSERT_EQ(b.upper_yz, a.upper_yz);
        ASSERT_EQ(b.origin_exponents.w >> 24, a.origin_exponents.w >> 24);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(std::bit_cast<float>(b.origin_exponents[axis]),
                      std::ldexp(std::bit_cast<float>(a.origin_exponents[axis]), k));
            const std::uint32_t exponent = (a.origin_exponents.w >> (8 * axis)) & 0xffu;
            const std::uint32_t expected = exponent == kFlatExponent
                                               ? exponent
                                               : static_cast<std::uint32_t>(static_cast<int>(exponent) + k);
            ASSERT_EQ((b.origin_exponents.w >> (8 * axis)) & 0xffu, expected);
        }
    }
}

TEST(Bvh, KeepsItsTopologyUnderPowersOfTwo) {
    for (const TriangleSoup& soup : {test::random_soup(5000, 0.1f), test::flat_grid(20, 1),
                                     test::to_soup(test::icosphere({0.5f, 0.25f, 4.0f}, 0.3f, 3))}) {
        const Bvh bvh = build_bvh(soup.positions, soup.triangles);
        for (const int k : {-20, -10, -1, 1, 10, 20}) {
            SCOPED_TRACE(k);
            const TriangleSoup larger = test::scaled(soup, std::ldexp(1.0f, k));
            const Bvh scaled = build_bvh(larger.positions, larger.triangles);
            EXPECT_EQ(scaled.order, bvh.order);
            EXPECT_EQ(scaled.depth, bvh.depth);
            expect_scaled_nodes(bvh, scaled, k);
        }
    }
}

TEST(Bvh, TurnsToMediansBeforeItGetsTooDeep) {
    // Every surface area split of these peels one triangle off, which alone would make a tree as deep as they
    // are many.
    const TriangleSoup soup = test::nested_soup(100);
    constexpr std::uint32_t kDepth = 9;  // 2 + log2(100), rounded up
    const BinaryBvh binary = build_binary_bvh(soup.positions, soup.triangles, kDepth);
    std::uint32_t deepest = 0;
    const auto visit = [&](const auto& self, std::uint32_t index, std::uint32_t depth) -> void {
        deepest = std::max(deepest, depth);
        const BinaryBvhNode& node = binary.nodes[index];
        if (node.is_leaf()) return;
        self(self, index + 1, depth + 1);
        self(self, node.right, depth + 1);
    };
    visit(visit, 0, 1);
    EXPECT_LE(deepest, kDepth);
    EXPECT_THROW(build_binary_bvh(soup.positions, soup.triangles, 7), CheckFailure);
}

}  // namespace
}  // namespace utsuri
