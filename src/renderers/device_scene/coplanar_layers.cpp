// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/coplanar_layers.h"

#include "renderers/device_scene/near_triangles.h"
#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace utsuri {
namespace {

/// Two corners and a plane that were meant to be in one place are off by a rounding of each coordinate, each;
/// a plane is also that of corners some of its size away. Some 16 roundings of three coordinates: 2^-24 times
/// 16 sqrt(3).
constexpr float kRoundings = 0x1p-19f;

/// Triangles that overlap by less than this many distances of layers are neighbours that share an edge.
constexpr double kLeastOverlap = 4.0;

/// Who lies on top of whom: the later in this order.
class Order {
  public:
    explicit Order(const SceneData& scene) : scene_(scene) {}

    /// Whether a lies on top of b where they overlap.
    [[nodiscard]] bool on_top(std::uint32_t a, std::uint32_t b) const {
        const interop::TriangleInfo& x = scene_.triangle_infos[a];
        const interop::TriangleInfo& y = scene_.triangle_infos[b];
        if (x.instance == y.instance) return later_vertices(x.vertices, y.vertices);
        const float size_x = size_of(x.instance);
        const float size_y = size_of(y.instance);
        return size_x != size_y ? size_x < size_y : x.instance > y.instance;
    }

  private:
    [[nodiscard]] float size_of(std::uint32_t instance) const {
        return glm::length(bounds_of(scene_, instance).extent());
    }
    static bool later_vertices(const glm::uvec3& a, const glm::uvec3& b) {
        for (int i = 0; i < 3; ++i) {
            if (a[i] != b[i]) return a[i] > b[i];
        }
        return false;
    }

    const SceneData& scene_;
};

using Corners2 = std::array<glm::dvec2, 3>;

/// Whether an edge of the first triangle has all of the second beyond it, but for a margin.
bool is_beyond_an_edge(const Corners2& a, const Corners2& b, double margin) {
    const double turn = cross(a[1] - a[0], a[2] - a[0]) > 0.0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 edge = a[(i + 1) % 3] - a[i];
        const double inside = turn / glm::length(edge);
        if (std::all_of(b.begin(), b.end(), [&](const glm::dvec2& corner) {
                return inside * cross(edge, corner - a[i]) <= margin;
            }))
            return true;
    }
    return false;
}

/// Finds overlapping pairs, each from its larger triangle, whose plane is known better.
class PairFinder {
  public:
    PairFinder(const SceneData& scene, double distance) : scene_(scene), distance_(distance) {}

    /// Triangles that overlap one in its plane and are not larger.
    [[nodiscard]] std::vector<std::uint32_t> overlapping(std::uint32_t triangle) const {
        const Corners corners = corners_of(scene_, triangle);
        const double area = glm::length(doubled_area(corners));
        if (area == 0.0) return {};
        const TriangleFrame frame(corners);
        std::vector<std::uint32_t> found;
        for (const std::uint32_t other : triangles_near_plane(scene_, triangle, frame, distance_)) {
            const Corners others = corners_of(scene_, other);
            const double other_area = glm::length(doubled_area(others));
            const bool is_larger = other_area > area || (other_area == area && other > triangle);
            if (other_area > 0.0 && !is_larger && overlaps(frame, others)) found.push_back(other);
        }
        return found;
    }

  private:
    [[nodiscard]] bool overlaps(const TriangleFrame& frame, const Corners& others) const {
        const bool is_coplanar = std::all_of(others.begin(), others.end(), [&](const glm::dvec3& corner) {
            return std::abs(frame.height(corner)) <= distance_;
        });
        if (!is_coplanar) return false;
        const Corners2 flat = {frame.project(others[0]), frame.project(others[1]), frame.project(others[2])};
        const double margin = kLeastOverlap * distance_;
        return !is_beyond_an_edge(frame.corners(), flat, margin) &&
               !is_beyond_an_edge(flat, frame.corners(), margin);
    }

    const SceneData& scene_;
    double distance_;
};

}  // namespace

float layer_distance(const SceneData& scene) {
    const glm::uvec4& root = scene.bvh.nodes.front().origin_exponents;
    float largest = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        const auto lower = std::bit_cast<float>(root[axis]);
        const auto cell = std::bit_cast<float>((root.w >> (8 * axis) & 0xffu) << 23);
        largest = std::max({largest, std::abs(lower), std::abs(lower + 255.0f * cell)});
    }
    return std::ldexp(kRoundings, std::ilogb(largest) + 1);
}

std::vector<std::uint32_t> count_layers(const SceneData& scene) {
    const auto triangles = static_cast<std::uint32_t>(scene.triangle_infos.size());
    if (triangles == 0) return {};
    const Order order(scene);
    const PairFinder finder(scene, static_cast<double>(layer_distance(scene)));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // the lower one, and what lies on it
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
        for (const std::uint32_t other : finder.overlapping(triangle)) {
            if (order.on_top(triangle, other)) pairs.emplace_back(other, triangle);
            if (order.on_top(other, triangle)) pairs.emplace_back(triangle, other);
        }
    }
    // From the top down: what lies on a triangle has been counted when its turn comes.
    std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
        return a.first != b.first
                   ? order.on_top(a.first, b.first) || (!order.on_top(b.first, a.first) && a.first < b.first)
                   : a.second < b.second;
    });
    std::vector<std::uint32_t> layers(triangles, 0);
    for (const auto& [lower, upper] : pairs)
        layers[lower] = std::min(std::max(layers[lower], layers[upper] + 1), interop::MOST_LAYERS);
    return layers;
}

}  // namespace utsuri
