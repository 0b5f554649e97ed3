// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/nodes.h"

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace utsuri {
namespace {

constexpr int kNoParent = -1;

/// A last row this far from (0, 0, 0, 1) is the rounding of a float32 exporter, and is taken as exact.
constexpr double kAffineTolerance = 1e-6;

glm::dmat4 matrix_transform(const Document& document, const std::vector<double>& m, std::size_t node) {
    glm::dmat4 transform(1.0);
    for (int i = 0; i < 16; ++i)
        transform[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
    for (int column = 0; column < 4; ++column) {
        const double right = column == 3 ? 1.0 : 0.0;
        if (std::abs(transform[column][3] - right) > kAffineTolerance) {
            document.fail(
                fmt::format("nodes[{}].matrix[{}]", node, 4 * column + 3),
                fmt::format("is {}; must be {}, as in every affine matrix", transform[column][3], right));
        }
        transform[column][3] = right;
    }
    return transform;
}

glm::dmat4 local_transform(const Document& document, std::size_t index) {
    const tinygltf::Node& node = document.model.nodes[index];
    if (!node.matrix.empty()) return matrix_transform(document, node.matrix, index);
    glm::dmat4 transform(1.0);
    if (!node.translation.empty()) {
        const auto& t = node.translation;
        transform = glm::translate(transform, glm::dvec3(t[0], t[1], t[2]));
    }
    if (!node.rotation.empty()) {
        const auto& r = node.rotation;
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        const double length = glm::length(rotation);
        if (!std::isfinite(length) || length == 0.0) {
            document.fail(fmt::format("nodes[{}].rotation", index),
                          fmt::format("has length {}; must be a unit quaternion", length));
        }
        transform *= glm::mat4_cast(glm::normalize(rotation));
    }
    if (!node.scale.empty()) {
        const auto& s = node.scale;
        transform = glm::scale(transform, glm::dvec3(s[0], s[1], s[2]));
    }
    return transform;
}

void check_finite(const Document& document, const glm::dmat4& transform, std::size_t node) {
    for (int i = 0; i < 16; ++i) {
        if (std::isfinite(transform[i / 4][i % 4])) continue;
        document.fail(fmt::format("nodes[{}]", node),
                      "the transform composed with its parents is not finite; must be");
    }
}

std::vector<int> parents(const Document& document) {
    const auto& nodes = document.model.nodes;
    std::vector<int> parent(nodes.size(), kNoParent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t c = 0; c < nodes[i].children.size(); ++c) {
            const auto child = static_cast<std::size_t>(nodes[i].children[c]);
            if (parent[child] != kNoParent) {
                document.fail(fmt::format("nodes[{}].children[{}]", i, c),
                              fmt::format("nodes[{}] is already a child of nodes[{}]; must have one parent",
                                          child, parent[child]));
            }
            parent[child] = static_cast<int>(i);
        }
    }
    return parent;
}

/// With one parent a node at most, the nodes on a cycle and below it are those that no root leads to.
void check_no_cycle(const Document& document, const std::vector<int>& parent) {
    std::vector<bool> reached(parent.size(), false);
    std::vector<int> open;
    for (std::size_t i = 0; i < parent.size(); ++i) {
        if (parent[i] == kNoParent) open.push_back(static_cast<int>(i));
    }
    while (!open.empty()) {
        const auto node = static_cast<std::size_t>(open.back());
        open.pop_back();
        reached[node] = true;
        const auto& children = document.model.nodes[node].children;
        open.insert(open.end(), children.begin(), children.end());
    }
    const auto missed = std::find(reached.begin(), reached.end(), false);
    if (missed == reached.end()) return;
    document.fail(fmt::format("nodes[{}]", missed - reached.begin()),
                  "is its own ancestor (a cycle), or below such a node; nodes must form trees");
}

/// -1 if the file has no scenes.
int drawn_scene(const Document& document) {
    if (document.model.defaultScene >= 0) return document.model.defaultScene;
    return document.model.scenes.empty() ? -1 : 0;
}

std::vector<int> drawn_roots(const Document& document, const std::vector<int>& parent) {
    const int scene = drawn_scene(document);
    std::vector<int> roots;
    if (scene < 0) {
        for (std::size_t i = 0; i < parent.size(); ++i) {
            if (parent[i] == kNoParent) roots.push_back(static_cast<int>(i));
        }
        return roots;
    }
    roots = document.model.scenes[static_cast<std::size_t>(scene)].nodes;
    std::vector<bool> listed(parent.size(), false);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const auto root = static_cast<std::size_t>(roots[i]);
        const std::string place = fmt::format("scenes[{}].nodes[{}]", scene, i);
        if (parent[root] != kNoParent) {
            document.fail(
                place, fmt::format("nodes[{}] is a child of nodes[{}]; must be a node without a parent", root,
                                   parent[root]));
        }
        if (listed[root])
            document.fail(place, fmt::format("nodes[{}] is listed twice; must be listed once", root));
        listed[root] = true;
    }
    return roots;
}

}  // namespace

std::vector<PlacedNode> place_nodes(const Document& document) {
    const std::vector<int> parent = parents(document);
    check_no_cycle(document, parent);
    const std::vector<int> roots = drawn_roots(document, parent);
    std::vector<PlacedNode> placed;
    std::vector<PlacedNode> open;
    const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& world_from_parent) {
        // Last first, because the stack is taken from its end.
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            open.push_back({static_cast<std::size_t>(*node), world_from_parent});
        }
    };
    push(roots, glm::dmat4(1.0));
    while (!open.empty()) {
        PlacedNode node = open.back();
        open.pop_back();
        node.world_from_node *= local_transform(document, node.node);
        check_finite(document, node.world_from_node, node.node);
        placed.push_back(node);
        push(document.model.nodes[node.node].children, node.world_from_node);
    }
    return placed;
}

std::string scene_name(const Document& document) {
    const int scene = drawn_scene(document);
    return scene < 0 ? std::string() : document.model.scenes[static_cast<std::size_t>(scene)].name;
}

}  // namespace utsuri
