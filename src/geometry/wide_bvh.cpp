// SPDX-License-Identifier: Apache-2.0
#include "geometry/wide_bvh.h"

#include "base/check.h"
#include "geometry/node_boxes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace utsuri {
namespace {

using interop::BVH_LEAF_TRIANGLES;
using interop::BVH_WIDTH;

/// Cost of testing a triangle relative to testing a node's eight boxes (Ylitie et al. 2017, section 3).
constexpr float kTriangleCost = 0.3f;
constexpr float kNodeCost = 1.0f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// For a subtree of the binary tree: the least cost of representing it by at most i roots, for i = 1 .. 7,
/// and how.
struct SubtreeCost {
    std::array<float, BVH_WIDTH> cost{};  ///< [i - 1]; the last entry is for the eight of a new node
    std::array<std::uint8_t, BVH_WIDTH>
        left_roots{};   ///< roots given to the left child; 0: use one root fewer
    bool leaf = false;  ///< with one root: a leaf, else a node
};

std::vector<SubtreeCost> subtree_costs(const BinaryBvh& binary) {
    std::vector<SubtreeCost> costs(binary.nodes.size());
    for (std::size_t n = binary.nodes.size(); n-- > 0;) {
        const BinaryBvhNode& node = binary.nodes[n];
        SubtreeCost& own = costs[n];
        const float area = node.bounds.half_area();
        const float leaf_cost = node.count <= BVH_LEAF_TRIANGLES
                                    ? area * kTriangleCost * static_cast<float>(node.count)
                                    : kInfinity;
        if (node.is_leaf()) {
            own.cost.fill(leaf_cost);
            own.leaf = true;
            continue;
        }
        const SubtreeCost& left = costs[n + 1];
        const SubtreeCost& right = costs[node.right];
        const auto distribute = [&](std::uint32_t roots) {
            float best = kInfinity;
            for (std::uint32_t k = 1; k < roots; ++k) {
                const float cost = left.cost[k - 1] + right.cost[roots - k - 1];
                if (cost < best || k == 1) {
                    best = cost;
                    own.left_roots[roots - 1] = static_cast<std::uint8_t>(k);
                }
            }
            return best;
        };
        const float node_cost = distribute(BVH_WIDTH) + area * kNodeCost;
        own.leaf = leaf_cost <= node_cost;
        own.cost[0] = std::min(leaf_cost, node_cost);
        for (std::uint32_t roots = 2; roots < BVH_WIDTH; ++roots) {
            own.cost[roots - 1] = distribute(roots);
            if (own.cost[roots - 2] <= own.cost[roots - 1]) {
                own.cost[roots - 1] = own.cost[roots - 2];
                own.left_roots[roots - 1] = 0;
            }
        }
    }
    return costs;
}

/// Children of one wide node by slot; NONE where a slot is empty.
using Slots = std::array<std::uint32_t, BVH_WIDTH>;

/// Puts each child where rays visit it in about the right order: slot s has bit a set for the upper side of
/// axis a, and the traversal takes slots in the order of s xor octant.
Slots assign_slots(const BinaryBvh& binary, const Bounds& parent,
                   const std::vector<std::uint32_t>& children) {
    const glm::vec3 parent_centre = parent.lower + parent.upper;
    Slots slots;
    slots.fill(interop::NONE);
    std::vector<std::uint32_t> waiting = children;
    while (!waiting.empty()) {
        float best = -kInfinity;
        std::size_t best_child = 0;
        std::uint32_t best_slot = interop::NONE;
        for (std::size_t c = 0; c < waiting.size(); ++c) {
            const Bounds& box = binary.nodes[waiting[c]].bounds;
            const glm::vec3 offset = (box.lower + box.upper) - parent_centre;
            for (std::uint32_t s = 0; s < BVH_WIDTH; ++s) {
                if (slots[s] != interop::NONE) continue;
                const float along = ((s & 1u) != 0 ? offset.x : -offset.x) +
                                    ((s & 2u) != 0 ? offset.y : -offset.y) +
                                    ((s & 4u) != 0 ? offset.z : -offset.z);
                if (along > best || best_slot == interop::NONE) {
                    best = along;
                    best_child = c;
                    best_slot = s;
                }
            }
        }
        slots[best_slot] = waiting[best_child];
        waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best_child));
    }
    return slots;
}

class Widener {
  public:
    explicit Widener(const BinaryBvh& binary) : binary_(binary), costs_(subtree_costs(binary)) {}

    WideBvh run() {
        result_.order.reserve(binary_.order.size());
        result_.nodes.emplace_back();
        if (!binary_.nodes.empty()) emit(0, 0, 1);
        result_.depth = std::max(result_.depth, 1u);
        return std::move(result_);
    }

  private:
    void emit(std::uint32_t binary_node, std::uint32_t wide_node, std::uint32_t depth) {
        result_.depth = std::max(result_.depth, depth);
        const BinaryBvhNode& node = binary_.nodes[binary_node];
        std::vector<std::uint32_t> children;
        if (costs_[binary_node].leaf) {
            children.push_back(binary_node);  // only the root can be a leaf here: it gets a node around it
        } else {
            const std::uint32_t left_roots = costs_[binary_node].left_roots[BVH_WIDTH - 1];
            collect(binary_node + 1, left_roots, children);
            collect(node.right, BVH_WIDTH - left_roots, children);
        }
        const Slots slots = assign_slots(binary_, node.bounds, children);
        const auto first_child = static_cast<std::uint32_t>(result_.nodes.size());
        result_.nodes[wide_node] = make_node(node.bounds, slots, first_child);

        std::uint32_t next = first_child;
        const auto is_node = [&](std::uint32_t child) {
            return child != interop::NONE && !costs_[child].leaf;
        };
        result_.nodes.resize(result_.nodes.size() +
                             static_cast<std::size_t>(std::count_if(slots.begin(), slots.end(), is_node)));
        for (const std::uint32_t child : slots) {
            if (is_node(child)) emit(child, next++, depth + 1);
        }
    }

    /// The subtrees that stand for `binary_node` when it may use `roots` of a node's slots.
    void collect(std::uint32_t binary_node, std::uint32_t roots, std::vector<std::uint32_t>& children) const {
        const SubtreeCost& cost = costs_[binary_node];
        while (roots > 1 && cost.left_roots[roots - 1] == 0)
            --roots;
        if (roots == 1 || binary_.nodes[binary_node].is_leaf()) {
            children.push_back(binary_node);
            return;
        }
        collect(binary_node + 1, cost.left_roots[roots - 1], children);
        collect(binary_.nodes[binary_node].right, roots - cost.left_roots[roots - 1], children);
    }

    interop::BvhNode make_node(const Bounds& bounds, const Slots& slots, std::uint32_t first_child) {
        std::array<std::uint32_t, BVH_WIDTH> meta{};
        std::uint32_t node_slots = 0;
        const auto first_triangle = static_cast<std::uint32_t>(result_.order.size());
        for (std::uint32_t s = 0; s < BVH_WIDTH; ++s) {
            if (slots[s] == interop::NONE) continue;
            if (!costs_[slots[s]].leaf) {
                meta[s] = 0x20u | (interop::BVH_NODE_BITS + s);
                node_slots |= 1u << s;
                continue;
            }
            const BinaryBvhNode& leaf = binary_.nodes[slots[s]];
            const auto offset = static_cast<std::uint32_t>(result_.order.size()) - first_triangle;
            meta[s] = (((1u << leaf.count) - 1u) << 5) | offset;
            for (std::uint32_t i = 0; i < leaf.count; ++i) {
                result_.order.push_back(binary_.order[leaf.first + i]);
            }
        }
        interop::BvhNode node{};
        node.origin_exponents.w = node_slots << 24;
        node.bases_meta = glm::uvec4(first_child, first_triangle, pack_bytes(meta));
        SlotBoxes boxes;
        for (std::uint32_t s = 0; s < BVH_WIDTH; ++s) {
            if (slots[s] != interop::NONE) boxes[s] = binary_.nodes[slots[s]].bounds;
        }
        set_boxes(node, bounds, boxes);
        return node;
    }

    const BinaryBvh& binary_;
    std::vector<SubtreeCost> costs_;
    WideBvh result_;
};

}  // namespace

WideBvh widen(const BinaryBvh& binary) {
    return Widener(binary).run();
}

}  // namespace utsuri
