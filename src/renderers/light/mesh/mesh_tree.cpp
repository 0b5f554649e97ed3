// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/mesh_tree.h"

#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace utsuri {
namespace {

constexpr std::array<glm::dvec2, 3> kCorners = {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

constexpr std::uint32_t next_of(std::uint32_t corner) {
    return corner == 2 ? 0 : corner + 1;
}

/// Of a difference of barycentric coordinates, in metres.
double length_over(const Corners& triangle, const glm::dvec2& b) {
    return glm::length(b.x * (triangle[1] - triangle[0]) + b.y * (triangle[2] - triangle[0]));
}

}  // namespace

MeshTree::MeshTree(const SceneData& scene, double finest, std::uint64_t most_points)
    : scene_(scene), finest_(finest), most_points_(most_points) {
    const auto triangles = static_cast<std::uint32_t>(scene.triangle_infos.size());
    nodes_.resize(triangles);
    std::vector<std::uint32_t> point_of_vertex(scene.normals.size(), interop::NONE);
    for (std::uint32_t t = 0; t < triangles; ++t)
        start(t, point_of_vertex);
}

void MeshTree::start(std::uint32_t triangle, std::vector<std::uint32_t>& point_of_vertex) {
    const interop::TriangleInfo& info = scene_.triangle_infos[triangle];
    if (!scene_.requirements.diffuse[info.material]) return;
    const Corners corners = corners_of(scene_, triangle);
    const glm::dvec3 area = doubled_area(corners);
    if (glm::length(area) == 0.0) return;
    MeshLeaf leaf;
    leaf.node = triangle;
    leaf.triangle = triangle;
    leaf.corners = kCorners;
    leaf.places = kCorners;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t vertex = info.vertices[i];
        // Triangles that share a vertex share the light there, unless one of them is shaded by its own
        // normal.
        const bool shares = glm::dot(glm::dvec3(scene_.normals[vertex]), area) > 0.0;
        std::uint32_t& shared = point_of_vertex[vertex];
        const std::uint32_t point = shares && shared != interop::NONE
                                        ? shared
                                        : add_point(triangle, kCorners[static_cast<std::size_t>(i)]);
        if (shares) shared = point;
        leaf.points[static_cast<std::size_t>(i)] = point;
    }
    nodes_[triangle].points = leaf.points;
    if (longest_edge(leaf).length <= finest_) return;
    leaves_.push_back(leaf);
    enlist(static_cast<std::uint32_t>(leaves_.size() - 1), interop::NONE);
}

double MeshTree::edge_length(const MeshLeaf& leaf, std::uint32_t edge) const {
    return length_over(corners_of(scene_, leaf.triangle), leaf.corners[next_of(edge)] - leaf.corners[edge]);
}

MeshTree::LongEdge MeshTree::longest_edge(const MeshLeaf& leaf) const {
    LongEdge longest{0, edge_length(leaf, 0)};
    for (std::uint32_t edge = 1; edge < 3; ++edge) {
        const double length = edge_length(leaf, edge);
        if (length > longest.length) longest = {edge, length};
    }
    return longest;
}

double MeshTree::area(const MeshLeaf& leaf) const {
    const glm::dvec2 a = leaf.corners[1] - leaf.corners[0];
    const glm::dvec2 b = leaf.corners[2] - leaf.corners[0];
    return 0.5 * std::abs(a.x * b.y - a.y * b.x) *
           glm::length(doubled_area(corners_of(scene_, leaf.triangle)));
}

bool MeshTree::can_split(std::uint32_t leaf) const {
    const MeshLeaf& divided = leaves_[leaf];
    return !divided.split && divided.depth < kMeshDepth && !is_full();
}

std::uint32_t MeshTree::add_point(std::uint32_t triangle, const glm::dvec2& place) {
    places_.push_back({triangle, static_cast<float>(place.x), static_cast<float>(place.y), 0, 0, 0});
    ends_.push_back({interop::NONE, interop::NONE});
    return static_cast<std::uint32_t>(places_.size() - 1);
}

void MeshTree::set_point(std::uint32_t leaf, std::uint32_t corner, std::uint32_t point,
                         const glm::dvec2& place) {
    MeshLeaf& changed = leaves_[leaf];
    changed.points[corner] = point;
    changed.places[corner] = place;
    nodes_[changed.node].points = changed.points;
    enlist(leaf, leaf);
}

MeshTree::Edge* MeshTree::find_edge(const MeshLeaf& leaf, std::uint32_t edge) {
    const auto found = edges_.find(edge_key(leaf.points[edge], leaf.points[next_of(edge)]));
    return found == edges_.end() ? nullptr : &found->second;
}

void MeshTree::enlist(std::uint32_t leaf, std::uint32_t parent) {
    const MeshLeaf& listed = leaves_[leaf];
    for (std::uint32_t edge = 0; edge < 3; ++edge) {
        const std::uint32_t a = listed.points[edge];
        const std::uint32_t b = listed.points[next_of(edge)];
        if (a == interop::NONE || b == interop::NONE || edge_length(listed, edge) <= finest_) continue;
        Edge& known = edges_[edge_key(a, b)];
        for (std::uint32_t& user : known.leaves) {
            if (user != parent && user != interop::NONE) continue;
            user = leaf;
            break;
        }
        if (known.split) unclosed_.push_back(leaf);
    }
}

std::uint32_t MeshTree::midpoint(std::uint32_t leaf, std::uint32_t edge) {
    const MeshLeaf& divided = leaves_[leaf];
    const std::uint32_t next = next_of(edge);
    const std::uint32_t a = divided.points[edge];
    const std::uint32_t b = divided.points[next];
    if (a == interop::NONE || b == interop::NONE) return interop::NONE;
    Edge& known = edges_[edge_key(a, b)];
    if (known.midpoint == interop::NONE) {
        known.midpoint = add_point(divided.triangle, 0.5 * (divided.places[edge] + divided.places[next]));
        ends_[known.midpoint] = {a, b};
    }
    return known.midpoint;
}

std::uint32_t MeshTree::add_child(const MeshLeaf& parent, std::uint32_t node,
                                  const std::array<std::uint32_t, 3>& points,
                                  const std::array<glm::dvec2, 3>& corners,
                                  const std::array<glm::dvec2, 3>& places) {
    nodes_[node].points = points;
    leaves_.push_back({node, parent.triangle, points, corners, places, parent.depth + 1, false});
    return static_cast<std::uint32_t>(leaves_.size() - 1);
}

std::uint32_t MeshTree::bisect(std::uint32_t leaf) {
    const std::uint32_t edge = longest_edge(leaves_[leaf]).edge;
    return split(leaf, edge, 0.5f, midpoint(leaf, edge));
}

std::uint32_t MeshTree::split(std::uint32_t leaf, std::uint32_t edge, float share, std::uint32_t point) {
    leaves_[leaf].split = true;
    const MeshLeaf parent = leaves_[leaf];
    const std::array<std::uint32_t, 3> at = {edge, next_of(edge), next_of(next_of(edge))};
    const auto mix = [&](const std::array<glm::dvec2, 3>& ends) {
        const auto s = static_cast<double>(share);
        return (1.0 - s) * ends[at[0]] + s * ends[at[1]];
    };
    const glm::dvec2 corner = mix(parent.corners);
    const glm::dvec2 place = mix(parent.places);
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[parent.node] = {edge, {}, share, node};
    const std::uint32_t first = add_child(parent, node, {parent.points[at[0]], point, parent.points[at[2]]},
                                          {parent.corners[at[0]], corner, parent.corners[at[2]]},
                                          {parent.places[at[0]], place, parent.places[at[2]]});
    add_child(parent, node + 1, {point, parent.points[at[1]], parent.points[at[2]]},
              {corner, parent.corners[at[1]], parent.corners[at[2]]},
              {place, parent.places[at[1]], parent.places[at[2]]});
    if (Edge* halved = find_edge(parent, edge);
        halved != nullptr && point != interop::NONE && halved->midpoint == point) {
        halved->split = true;
        for (const std::uint32_t user : halved->leaves) {
            if (user != leaf && user != interop::NONE) unclosed_.push_back(user);
        }
    }
    enlist(first, leaf);
    enlist(first + 1, leaf);
    return first;
}

void MeshTree::close() {
    while (!unclosed_.empty()) {
        const std::uint32_t leaf = unclosed_.back();
        unclosed_.pop_back();
        if (!can_split(leaf)) continue;
        bool has_split_edge = false;
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const Edge* known = find_edge(leaves_[leaf], edge);
            has_split_edge = has_split_edge || (known != nullptr && known->split);
        }
        if (has_split_edge) bisect(leaf);
    }
}

}  // namespace utsuri
