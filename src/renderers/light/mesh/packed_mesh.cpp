// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/packed_mesh.h"

#include "base/check.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace utsuri {
namespace {

/// Cells of a grid for each leaf of its triangle, about. Leaves gather where light changes, so that even with
/// 16 half of the cells hold a split.
constexpr std::uint64_t kCellsPerLeaf = 4;

/// How far beyond the edges of a cell splits are looked at that light does not jump at, in cells: more than
/// the rounding of which cell a place is in.
constexpr double kRounding = 1e-3;
/// The same of cuts: see kept_light().
constexpr double kCutMargin = 1.0;

/// Linear over a triangle: x + y b1 + z b2, with its barycentric coordinates b1 and b2.
using Linear = glm::dvec3;
/// The barycentric coordinates of a part of it.
using Coordinates = std::array<Linear, 3>;
constexpr Coordinates kWhole = {Linear(1, -1, -1), Linear(0, 1, 0), Linear(0, 0, 1)};

/// A split as its node has it.
struct Split {
    Linear beyond;  ///< positive in the second child, negative in the first
    std::array<Coordinates, 2> children;
};

Split split_of(const MeshNode& node, const Coordinates& coordinates) {
    const Linear& a = coordinates[node.split];
    const Linear& b = coordinates[(node.split + 1) % 3];
    const Linear& c = coordinates[(node.split + 2) % 3];
    const auto share = static_cast<double>(node.share);
    const Linear beyond = b * (1.0 - share) - a * share;
    return {beyond,
            {Coordinates{-beyond / share, b / share, c}, {a / (1.0 - share), beyond / (1.0 - share), c}}};
}

/// A split as kernels read it, and what it is made of.
interop::LightMeshSplit scaled_split(const Linear& beyond, bool is_cut,
                                     std::array<std::uint32_t, 2> children) {
    const bool by_b2 = std::abs(beyond.z) > std::abs(beyond.y);
    const double scale = by_b2 ? beyond.z : beyond.y;
    if (scale < 0.0) std::swap(children[0], children[1]);
    interop::LightMeshSplit split{};
    split.constant = static_cast<float>(beyond.x / scale);
    split.slope = static_cast<float>((by_b2 ? beyond.y : beyond.z) / scale);
    split.first = children[0] | (by_b2 ? interop::LIGHT_MESH_BY_B2 : 0);
    split.second = children[1] | (is_cut ? interop::LIGHT_MESH_CUT : 0);
    return split;
}

/// A square of a grid, in barycentric coordinates.
struct Cell {
    glm::dvec2 lower;
    double edge;
};

/// What may be positive or negative over a cell and a margin about it, in cells.
struct Range {
    double least;
    double most;
};

Range range_over(const interop::LightMeshSplit& split, const Cell& cell, double margin) {
    const bool by_b2 = (split.first & interop::LIGHT_MESH_BY_B2) != 0;
    const auto slope = static_cast<double>(split.slope);
    const glm::dvec2 slopes = by_b2 ? glm::dvec2(slope, 1.0) : glm::dvec2(1.0, slope);
    const glm::dvec2 middle = cell.lower + 0.5 * cell.edge;
    const double value = static_cast<double>(split.constant) + slopes.x * middle.x + slopes.y * middle.y;
    const double reach = (0.5 + margin) * cell.edge * (std::abs(slopes.x) + std::abs(slopes.y));
    return {value - reach, value + reach};
}

/// The bounds of light on a leaf: LightMeshSide. A zero that has a sign counts as one without.
std::uint32_t bounds_word(float least, float most) {
    constexpr std::uint32_t kUpperHalf = 0xffff0000u;
    constexpr std::uint32_t kLargest = 0x7f7f0000u;  // of what is finite
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::abs(most));
    const std::uint32_t above = std::min((bits + 0xffffu) & kUpperHalf, kLargest);
    return above | std::bit_cast<std::uint32_t>(std::abs(least)) >> 16;
}

/// On a narrow leaf bright light may be too steep for a float. Three of these have a finite sum, and what it
/// is off is bounded by what is on the leaf.
glm::vec3 finite(const glm::dvec3& linear) {
    constexpr double kMost = double{std::numeric_limits<float>::max()} / 4.0;
    return {glm::clamp(linear, -kMost, kMost)};
}

class Packer {
  public:
    explicit Packer(const LightMesh& mesh) : mesh_(mesh) {}

    PackedMesh pack(std::uint32_t roots) {
        packed_.nodes.resize(roots);
        for (std::uint32_t root = 0; root < roots; ++root)
            packed_.nodes[root] = std::bit_cast<MeshTexel>(pack_root(root));
        UTSURI_CHECK_LE(packed_.nodes.size(), std::size_t{interop::LIGHT_MESH_INDEX});
        UTSURI_CHECK_LE(packed_.sides.size(), std::size_t{interop::LIGHT_MESH_INDEX});
        return std::move(packed_);
    }

  private:
    interop::LightMeshRoot pack_root(std::uint32_t root) {
        const MeshNode& node = mesh_.nodes[root];
        if (node.split == kMeshLeaf && node.points[0] == interop::NONE) return {interop::NONE, 0, 0, 0};
        leaves_ = 0;
        const std::uint32_t tree = pack_node(root, kWhole);
        if (leaves_ == 1) return {tree, 0, 0, 0};
        const auto rows = static_cast<std::uint32_t>(
            std::ceil(std::sqrt(2.0 * static_cast<double>(kCellsPerLeaf * leaves_))));
        return {tree, rows, add_grid(tree, rows), 0};
    }

    /// @returns what refers to it
    std::uint32_t pack_node(std::uint32_t index, const Coordinates& coordinates) {
        const MeshNode& node = mesh_.nodes[index];
        if (node.split == kMeshLeaf) return pack_leaf(node, coordinates);
        const auto place = static_cast<std::uint32_t>(packed_.nodes.size());
        packed_.nodes.emplace_back();
        const Split split = split_of(node, coordinates);
        std::array<std::uint32_t, 2> children{};
        for (std::uint32_t i = 0; i < 2; ++i)
            children[i] = pack_node(node.child + i, split.children[i]);
        packed_.nodes[place] =
            std::bit_cast<MeshTexel>(scaled_split(split.beyond, node.share != 0.5f, children));
        return place;
    }

    std::uint32_t pack_leaf(const MeshNode& node, const Coordinates& coordinates) {
        ++leaves_;
        const auto first = static_cast<std::uint32_t>(packed_.sides.size());
        std::uint32_t reference = interop::LIGHT_MESH_LEAF | first;
        if (add_side(node, coordinates, &interop::LightMeshPoint::front))
            reference |= interop::LIGHT_MESH_FRONT;
        if (add_side(node, coordinates, &interop::LightMeshPoint::back))
            reference |= interop::LIGHT_MESH_BACK;
        return reference;
    }

    /// @returns false if it is black
    bool add_side(const MeshNode& node, const Coordinates& coordinates,
                  glm::vec3 interop::LightMeshPoint::*light) {
        std::array<glm::dvec3, 3> linear{};  // constant, along b1, along b2
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 most(0.0f);
        for (std::size_t i = 0; i < 3; ++i) {
            if (node.points[i] == interop::NONE) return false;
            const glm::vec3 at_corner = mesh_.points[node.points[i]].*light;
            least = glm::min(least, at_corner);
            most = glm::max(most, at_corner);
            for (int c = 0; c < 3; ++c)
                linear[static_cast<std::size_t>(c)] += coordinates[i][c] * glm::dvec3(at_corner);
        }
        if (most == glm::vec3(0.0f)) return false;
        packed_.sides.push_back({finite(linear[0]), bounds_word(least.x, most.x), finite(linear[1]),
                                 bounds_word(least.y, most.y), finite(linear[2]),
                                 bounds_word(least.z, most.z)});
        return true;
    }

    /// @returns its first cell
    std::uint32_t add_grid(std::uint32_t tree, std::uint32_t rows) {
        const auto first = static_cast<std::uint32_t>(packed_.nodes.size());
        packed_.nodes.reserve(first + std::size_t{rows} * (rows + 1) / 2);
        for (std::uint32_t j = 0; j < rows; ++j) {
            for (std::uint32_t i = 0; i + j < rows; ++i) {
                const Cell cell{glm::dvec2(i, j) / static_cast<double>(rows), 1.0 / rows};
                packed_.nodes.push_back(std::bit_cast<MeshTexel>(split_of_cell(cell, tree)));
            }
        }
        return first;
    }

    /// The first split of a tree that divides a cell and what is about it.
    [[nodiscard]] interop::LightMeshSplit split_of_cell(const Cell& cell, std::uint32_t tree) const {
        while ((tree & interop::LIGHT_MESH_LEAF) == 0) {
            const auto split =
                std::bit_cast<interop::LightMeshSplit>(packed_.nodes[tree & interop::LIGHT_MESH_INDEX]);
            const bool is_cut = (split.second & interop::LIGHT_MESH_CUT) != 0;
            const Range range = range_over(split, cell, is_cut ? kCutMargin : kRounding);
            if (range.least <= 0.0 && range.most >= 0.0) return split;
            tree = range.least > 0.0 ? split.second : split.first;
        }
        // Bits beside the leaf's own tell of the split that it was found by.
        const std::uint32_t leaf = tree & ~(interop::LIGHT_MESH_BY_B2 | interop::LIGHT_MESH_CUT);
        return {0.0f, 0.0f, leaf, leaf};
    }

    const LightMesh& mesh_;
    PackedMesh packed_;
    std::uint64_t leaves_ = 0;  ///< of the triangle that is packed
};

}  // namespace

PackedBytes packed_bytes_per_point() {
    constexpr std::uint64_t kLeavesPerPoint = 2;
    // A grid has kCellsPerLeaf cells and, as rows are rounded up, at most half as many again.
    constexpr std::uint64_t kCellBytes = kCellsPerLeaf * sizeof(interop::LightMeshSplit) * 3 / 2;
    return {kLeavesPerPoint * (sizeof(interop::LightMeshSplit) + kCellBytes),
            kLeavesPerPoint * 2 * sizeof(interop::LightMeshSide)};
}

std::uint64_t most_packed_points(std::uint64_t triangles, std::uint64_t buffer_bytes) {
    const PackedBytes per_point = packed_bytes_per_point();
    const std::uint64_t bytes =
        std::min<std::uint64_t>(buffer_bytes, std::uint64_t{interop::LIGHT_MESH_INDEX} * sizeof(MeshTexel));
    const std::uint64_t roots = std::min(bytes, triangles * sizeof(MeshTexel));
    return std::min((bytes - roots) / per_point.nodes, buffer_bytes / per_point.sides);
}

PackedMesh pack(const LightMesh& mesh, std::uint32_t roots) {
    return Packer(mesh).pack(roots);
}

}  // namespace utsuri
