// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh_check.h"

#include "support/triangle_soup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace utsuri {
namespace {

using testing::HasSubstr;

/// A sound BVH into which each test plants one fault.
class BvhCheck : public testing::Test {
  protected:
    void SetUp() override { ASSERT_EQ(problem(), ""); }

    [[nodiscard]] std::string problem() const { return check_bvh(bvh_, soup_.triangles.size()); }

    /// A slot of the root that holds a node.
    [[nodiscard]] std::uint32_t node_slot() const {
        for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH; ++slot) {
            if (slot_content(bvh_.nodes[0], slot).is_node) return slot;
        }
        ADD_FAILURE() << "the root has no child node";
        return 0;
    }

    /// A node and slot that hold a leaf of at least `triangles`.
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> leaf_slot(std::uint32_t triangles) const {
        for (std::uint32_t node = 0; node < bvh_.nodes.size(); ++node) {
            for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH; ++slot) {
                if (slot_content(bvh_.nodes[node], slot).triangle_count >= triangles) return {node, slot};
            }
        }
        ADD_FAILURE() << "no leaf of " << triangles << " triangles";
        return {0, 0};
    }

    test::TriangleSoup soup_ = test::random_soup(1000, 0.1f);
    Bvh bvh_ = build_bvh(soup_.positions, soup_.triangles);
};

TEST_F(BvhCheck, FindsAWrongNumberOfTriangles) {
    EXPECT_THAT(check_bvh(bvh_, 999), HasSubstr("1000 triangles"));
    bvh_.order.pop_back();
    EXPECT_THAT(problem(), HasSubstr("999 order entries"));
}

TEST_F(BvhCheck, FindsAnOrderThatIsNoPermutation) {
    bvh_.order[5] = bvh_.order[6];
    EXPECT_THAT(problem(), HasSubstr("order is no permutation"));
    bvh_.order[5] = 1000;
    EXPECT_THAT(problem(), HasSubstr("order is no permutation at 5"));
}

TEST_F(BvhCheck, FindsSwappedTriangles) {
    std::swap(bvh_.triangles.front(), bvh_.triangles.back());
    EXPECT_THAT(problem(), HasSubstr("leaves its box"));
}

TEST_F(BvhCheck, FindsAVertexOneFloatOutside) {
    const auto [node, slot] = leaf_slot(1);
    const auto bound = static_cast<float>(child_box(bvh_.nodes[node], slot).upper.x);
    interop::BvhTriangle& triangle = bvh_.triangles[slot_content(bvh_.nodes[node], slot).first_triangle];
    triangle.v1.x = std::nextafter(bound, std::numeric_limits<float>::infinity());
    EXPECT_THAT(problem(), HasSubstr("leaves its box"));
}

TEST_F(BvhCheck, FindsAShrunkBox) {
    // The upper x bytes of slots 0-3 and 4-7 are words z and w of lower_z_upper_x.
    const std::uint32_t slot = node_slot();
    const int word = slot < 4 ? 2 : 3;
    bvh_.nodes[0].lower_z_upper_x[word] &= ~(0xffu << (8 * (slot % 4)));
    EXPECT_THAT(problem(), HasSubstr("leaves its box"));
}

TEST_F(BvhCheck, FindsACellOfHalfTheSize) {
    bvh_.nodes[0].origin_exponents.w -= 1u << 8;
    EXPECT_THAT(problem(), HasSubstr("leaves its box"));
}

TEST_F(BvhCheck, FindsAWrongDepth) {
    ++bvh_.depth;
    EXPECT_THAT(problem(), HasSubstr("stated"));
    bvh_.depth -= 2;
    EXPECT_THAT(problem(), HasSubstr("stated"));
}

TEST_F(BvhCheck, FindsANodeThatIsNotReached) {
    bvh_.nodes.push_back(bvh_.nodes.back());
    EXPECT_THAT(problem(), HasSubstr("is not reached"));
}

TEST_F(BvhCheck, FindsANodeThatDoesNotExist) {
    bvh_.nodes[0].bases_meta.x = static_cast<std::uint32_t>(bvh_.nodes.size());
    EXPECT_THAT(problem(), HasSubstr("does not exist"));
}

TEST_F(BvhCheck, FindsACycle) {
    bvh_.nodes[0].bases_meta.x = 0;
    EXPECT_THAT(problem(), HasSubstr("reached twice"));
}

TEST_F(BvhCheck, FindsALeafThatDropsATriangle) {
    const auto [node, slot] = leaf_slot(2);
    const int word = slot < 4 ? 2 : 3;
    const std::uint32_t shift = 8 * (slot % 4);
    const std::uint32_t meta = (bvh_.nodes[node].bases_meta[word] >> shift) & 0xffu;
    // The unary count in the upper three bits loses its highest bit.
    const std::uint32_t fewer = ((meta >> 6) << 5) | (meta & 0x1fu);
    bvh_.nodes[node].bases_meta[word] ^= (meta ^ fewer) << shift;
    EXPECT_THAT(problem(), HasSubstr("is not reached"));
}

TEST_F(BvhCheck, FindsTwoLeavesOfOneTriangle) {
    for (interop::BvhNode& node : bvh_.nodes)
        node.bases_meta.y = 0;
    EXPECT_NE(problem(), "");
}

}  // namespace
}  // namespace utsuri
