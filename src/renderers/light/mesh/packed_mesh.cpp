// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/packed_mesh.h"

#include "base/check.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace utsuri {
namespace {

/// Halvings of one node, at most: 32 children.
constexpr std::uint32_t kMostHalvings = 5;

/// In the children of a halved node, the edge that their newest corner, the split point, looks at.
constexpr std::uint32_t kNextOfFirst = 2;
constexpr std::uint32_t kNextOfSecond = 1;

/// Barycentric coordinates of a node, differentiated by b1 and b2 of the whole triangle.
using Gradients = std::array<glm::dvec2, 3>;

constexpr Gradients kWhole = {glm::dvec2(-1, -1), glm::dvec2(1, 0), glm::dvec2(0, 1)};

/// A node that is to be packed.
struct Item {
    std::uint32_t node;
    std::uint32_t corner;  ///< corners are counted from this one
    Gradients gradients;
};

/// Of what is positive in the second child of a node, negative in the first, and of the coordinates on both.
struct SplitGradients {
    glm::dvec2 beyond;
    std::array<Gradients, 2> children;
};

SplitGradients split_gradients(const MeshNode& node, const Gradients& gradients) {
    const glm::dvec2& a = gradients[node.split];
    const glm::dvec2& b = gradients[(node.split + 1) % 3];
    const glm::dvec2& c = gradients[(node.split + 2) % 3];
    const auto share = static_cast<double>(node.share);
    const glm::dvec2 beyond = b * (1.0 - share) - a * share;
    return {beyond,
            {Gradients{-beyond / share, b / share, c}, {a / (1.0 - share), beyond / (1.0 - share), c}}};
}

std::uint32_t head(std::uint32_t kind, std::uint32_t corner, std::uint32_t halvings, std::uint32_t child) {
    constexpr std::uint32_t kHalvingsAt = interop::LIGHT_MESH_KIND_BITS + interop::LIGHT_MESH_CORNER_BITS;
    return kind | (corner << interop::LIGHT_MESH_KIND_BITS) | (halvings << kHalvingsAt) |
           (child << (kHalvingsAt + interop::LIGHT_MESH_HALVINGS_BITS));
}

std::uint32_t bits_of(double value) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

class Packer {
  public:
    explicit Packer(const LightMesh& mesh) : mesh_(mesh), numbers_(mesh.points.size(), interop::NONE) {}

    PackedMesh pack(std::uint32_t roots) {
        packed_.nodes.resize(roots);
        for (std::uint32_t root = 0; root < roots; ++root) {
            work_.push_back({{root, 0, kWhole}, root});
            while (!work_.empty()) {
                const Work next = work_.back();
                work_.pop_back();
                pack(next.item, next.target);
            }
        }
        UTSURI_CHECK_LE(packed_.nodes.size(), kMostPackedNodes);
        return std::move(packed_);
    }

  private:
    struct Work {
        Item item;
        std::uint32_t target;  ///< where it becomes a packed node
    };

    void pack(const Item& item, std::uint32_t target) {
        const MeshNode& node = mesh_.nodes[item.node];
        if (node.split == kMeshLeaf) {
            pack_leaf(item, target);
        } else if (node.share == 0.5f) {
            pack_halvings(item, target);
        } else {
            pack_cut(item, target);
        }
    }

    void pack_leaf(const Item& item, std::uint32_t target) {
        std::array<std::uint32_t, 3> points{};
        for (std::uint32_t i = 0; i < 3; ++i)
            points[i] = number_of(mesh_.nodes[item.node].points[(item.corner + i) % 3]);
        packed_.nodes[target] = {interop::LIGHT_MESH_LEAF, points[0], points[1], points[2]};
    }

    /// Of a point among the packed ones.
    std::uint32_t number_of(std::uint32_t point) {
        if (point == interop::NONE) return interop::NONE;
        std::uint32_t& number = numbers_[point];
        if (number == interop::NONE) {
            number = static_cast<std::uint32_t>(packed_.points.size());
            packed_.points.push_back(mesh_.points[point]);
        }
        return number;
    }

    void pack_halvings(const Item& item, std::uint32_t target) {
        std::vector<Item> parts = {item};
        std::uint32_t halvings = 0;
        while (halvings == 0 || (halvings < kMostHalvings && are_halved_alike(parts))) {
            std::vector<Item> next;
            for (const Item& part : parts) {
                const MeshNode& node = mesh_.nodes[part.node];
                const SplitGradients split = split_gradients(node, part.gradients);
                next.push_back({node.child, kNextOfFirst, split.children[0]});
                next.push_back({node.child + 1, kNextOfSecond, split.children[1]});
            }
            parts = std::move(next);
            ++halvings;
        }
        const std::uint32_t child = add(parts);
        packed_.nodes[target] = {head(interop::LIGHT_MESH_HALVED, split_edge(item), halvings, child), 0, 0,
                                 0};
    }

    void pack_cut(const Item& item, std::uint32_t target) {
        const MeshNode& node = mesh_.nodes[item.node];
        const SplitGradients split = split_gradients(node, item.gradients);
        const std::uint32_t child =
            add({{node.child, 0, split.children[0]}, {node.child + 1, 0, split.children[1]}});
        packed_.nodes[target] = {head(interop::LIGHT_MESH_CUT, split_edge(item), 0, child),
                                 std::bit_cast<std::uint32_t>(node.share), bits_of(std::abs(split.beyond.x)),
                                 bits_of(std::abs(split.beyond.y))};
    }

    /// The edge at which a node is split, from the corner that corners are counted from.
    [[nodiscard]] std::uint32_t split_edge(const Item& item) const {
        return (mesh_.nodes[item.node].split + 3 - item.corner) % 3;
    }
    /// Whether all parts of a halved node are halved where their newest corner looks.
    [[nodiscard]] bool are_halved_alike(const std::vector<Item>& parts) const {
        return std::all_of(parts.begin(), parts.end(), [&](const Item& part) {
            const MeshNode& node = mesh_.nodes[part.node];
            return node.split != kMeshLeaf && node.share == 0.5f && split_edge(part) == 0;
        });
    }

    /// @returns where the first of some items becomes a node; the others follow
    std::uint32_t add(const std::vector<Item>& items) {
        const auto first = static_cast<std::uint32_t>(packed_.nodes.size());
        packed_.nodes.resize(packed_.nodes.size() + items.size());
        for (std::size_t i = items.size(); i-- > 0;)
            work_.push_back({items[i], first + static_cast<std::uint32_t>(i)});
        return first;
    }

    const LightMesh& mesh_;
    PackedMesh packed_;
    std::vector<std::uint32_t> numbers_;  ///< of points among the packed ones; NONE before they are
    std::vector<Work> work_;              ///< the next one last, so that what is near lies together
};

}  // namespace

PackedMesh pack(const LightMesh& mesh, std::uint32_t roots) {
    return Packer(mesh).pack(roots);
}

}  // namespace utsuri
