// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/light/mesh/light_mesh.h"

#include "interop/light_mesh.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace utsuri {

/// A triangle of the mesh that may be split.
struct MeshLeaf {
    std::uint32_t node = 0;
    std::uint32_t triangle = 0;  ///< of the scene
    /// At its corners; NONE where a point is still to be made: MeshTree::set_point().
    std::array<std::uint32_t, 3> points{};
    std::array<glm::dvec2, 3> corners{};  ///< barycentric coordinates b1, b2
    /// Where light at the corners is simulated: there, or a little inside the leaf, off what touches it
    /// there.
    std::array<glm::dvec2, 3> places{};
    std::uint32_t depth = 0;  ///< splits above it
    bool split = false;       ///< it is a leaf no more
};

/// The mesh while it grows: leaves are split at their longest edges (Rivara 1984), so that shapes stay good
/// and neighbours, in other triangles of the scene too, have the same points on the edge between them.
class MeshTree {
  public:
    /// Starts with the triangles of a scene; those without a diffuse part, or without an area, keep no light.
    /// @param scene must outlive this
    /// @param finest edges that are no longer are not split, metres
    /// @param most_points that there is room for: nothing is split after
    MeshTree(const SceneData& scene, double finest, std::uint64_t most_points);

    [[nodiscard]] const std::vector<MeshNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<interop::LightMeshPlace>& places() const { return places_; }
    /// Between which points a point was made, by midpoint(); else NONE.
    using Ends = std::array<std::uint32_t, 2>;
    [[nodiscard]] const Ends& ends(std::uint32_t point) const { return ends_[point]; }
    /// Groups of lights that are taken for lit or dark at a point: LightMeshPlace.
    void expect(std::uint32_t point, std::uint32_t lit, std::uint32_t dark) {
        places_[point].lit = lit;
        places_[point].dark = dark;
    }
    /// Leaves with an edge longer than the finest, and those made of them.
    [[nodiscard]] const std::vector<MeshLeaf>& leaves() const { return leaves_; }
    [[nodiscard]] double edge_length(const MeshLeaf& leaf, std::uint32_t edge) const;
    /// The edge, and how long it is.
    struct LongEdge {
        std::uint32_t edge;
        double length;
    };
    [[nodiscard]] LongEdge longest_edge(const MeshLeaf& leaf) const;
    [[nodiscard]] double area(const MeshLeaf& leaf) const;
    [[nodiscard]] bool is_full() const { return places_.size() >= most_points_; }
    /// Whether it is a leaf and there is room for its children.
    [[nodiscard]] bool can_split(std::uint32_t leaf) const;

    /// The point in the middle of an edge, a new one where there is none; NONE where an end of the edge is
    /// none.
    std::uint32_t midpoint(std::uint32_t leaf, std::uint32_t edge);
    /// A point of one triangle alone.
    std::uint32_t add_point(std::uint32_t triangle, const glm::dvec2& place);
    void set_point(std::uint32_t leaf, std::uint32_t corner, std::uint32_t point, const glm::dvec2& place);

    /// @returns the first of its two children among leaves(); the other one follows it
    std::uint32_t bisect(std::uint32_t leaf);
    /// @param share of the way along the edge, in (0, 1)
    /// @param point there, or NONE
    std::uint32_t split(std::uint32_t leaf, std::uint32_t edge, float share, std::uint32_t point);
    /// Splits leaves until none has a point of a neighbour in the middle of an edge; along contacts, and
    /// where more than two triangles of the scene meet, some do.
    void close();

  private:
    /// Between two points.
    struct Edge {
        std::uint32_t midpoint = interop::NONE;
        std::array<std::uint32_t, 2> leaves{interop::NONE, interop::NONE};
        bool split = false;
    };

    /// Null if nothing is known of the edge.
    [[nodiscard]] Edge* find_edge(const MeshLeaf& leaf, std::uint32_t edge);
    /// Makes a leaf known to its edges, in place of the one that it was made of.
    void enlist(std::uint32_t leaf, std::uint32_t parent);
    std::uint32_t add_child(const MeshLeaf& parent, std::uint32_t node,
                            const std::array<std::uint32_t, 3>& points,
                            const std::array<glm::dvec2, 3>& corners,
                            const std::array<glm::dvec2, 3>& places);
    void start(std::uint32_t triangle, std::vector<std::uint32_t>& point_of_vertex);

    const SceneData& scene_;
    double finest_;
    std::uint64_t most_points_;
    std::vector<MeshNode> nodes_;
    std::vector<interop::LightMeshPlace> places_;
    std::vector<Ends> ends_;
    std::vector<MeshLeaf> leaves_;
    std::unordered_map<std::uint64_t, Edge> edges_;
    std::vector<std::uint32_t> unclosed_;  ///< leaves that may have a split edge
};

}  // namespace utsuri
