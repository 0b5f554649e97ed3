// SPDX-License-Identifier: Apache-2.0
#include "geometry/binary_bvh.h"

#include "base/check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <future>
#include <numeric>

namespace utsuri {
namespace {

constexpr int kBins = 32;
/// Subtrees below this many triangles are not worth a thread of their own.
constexpr std::uint32_t kParallelTriangles = 1u << 15;

struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;
};

struct Split {
    float cost =
        std::numeric_limits<float>::infinity();  ///< sum of half area times triangles over both sides
    int axis = -1;
    int bin = 0;  ///< triangles in bins up to this one go left
};

class Builder {
  public:
    Builder(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
            std::uint32_t max_depth)
        : max_depth_(max_depth), boxes_(triangles.size()) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            for (int k = 0; k < 3; ++k)
                boxes_[i].extend(positions[triangles[i][k]]);
        }
        bvh_.order.resize(triangles.size());
        std::iota(bvh_.order.begin(), bvh_.order.end(), 0u);
        bvh_.nodes.resize(triangles.empty() ? 0 : 2 * triangles.size() - 1);
    }

    BinaryBvh build() {
        if (!bvh_.nodes.empty()) build_node(0, 0, static_cast<std::uint32_t>(boxes_.size()), 1);
        return std::move(bvh_);
    }

  private:
    /// Twice the centroid of a triangle's box: a factor that no comparison needs is not divided out.
    [[nodiscard]] glm::vec3 centroid(std::uint32_t triangle) const {
        return boxes_[triangle].lower + boxes_[triangle].upper;
    }

    void build_node(std::uint32_t index, std::uint32_t first, std::uint32_t count, std::uint32_t depth) {
        BinaryBvhNode& node = bvh_.nodes[index];
        Bounds centroids;
        for (std::uint32_t i = first; i < first + count; ++i) {
            node.bounds.extend(boxes_[bvh_.order[i]]);
            centroids.extend(centroid(bvh_.order[i]));
        }
        node.first = first;
        node.count = count;
        if (count == 1) return;

        const std::uint32_t left_count = partition(first, count, depth, centroids);
        const std::uint32_t left = index + 1;
        const std::uint32_t right = index + 2 * left_count;
        node.right = right;
        if (count >= kParallelTriangles && depth < 6) {
            auto other =
                std::async(std::launch::async, [=, this] { build_node(left, first, left_count, depth + 1); });
            build_node(right, first + left_count, count - left_count, depth + 1);
            other.get();
        } else {
            build_node(left, first, left_count, depth + 1);
            build_node(right, first + left_count, count - left_count, depth + 1);
        }
    }

    /// Orders the triangles of a node into a left and a right side; returns how many are left, in [1, count -
    /// 1].
    std::uint32_t partition(std::uint32_t first, std::uint32_t count, std::uint32_t depth,
                            const Bounds& centroids) {
        const auto begin = bvh_.order.begin() + first;
        const auto levels_for_medians = static_cast<std::uint32_t>(std::bit_width(count - 1));
        const Split split =
            depth + levels_for_medians < max_depth_ ? best_split(first, count, centroids) : Split{};
        if (split.axis < 0) return split_at_median(first, count, centroids);
        const float lower = centroids.lower[split.axis];
        const float scale = bin_scale(centroids, split.axis);
        const auto middle = std::partition(begin, begin + count, [&](std::uint32_t triangle) {
            return bin_of(centroid(triangle)[split.axis], lower, scale) <= split.bin;
        });
        return static_cast<std::uint32_t>(middle - begin);
    }

    std::uint32_t split_at_median(std::uint32_t first, std::uint32_t count, const Bounds& centroids) {
        const glm::vec3 extent = centroids.extent();
        const int axis =
            extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
        const std::uint32_t left_count = count / 2;
        const auto begin = bvh_.order.begin() + first;
        std::nth_element(begin, begin + left_count, begin + count, [&](std::uint32_t a, std::uint32_t b) {
            const float ca = centroid(a)[axis];
            const float cb = centroid(b)[axis];
            return ca != cb ? ca < cb : a < b;
        });
        return left_count;
    }

    static float bin_scale(const Bounds& centroids, int axis) {
        return static_cast<float>(kBins) / centroids.extent()[axis];
    }

    static int bin_of(float centroid, float lower, float scale) {
        return std::min(static_cast<int>((centroid - lower) * scale), kBins - 1);
    }

    Split best_split(std::uint32_t first, std::uint32_t count, const Bounds& centroids) const {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const float scale = bin_scale(centroids, axis);
            if (!(centroids.extent()[axis] > 0.0f) || !std::isfinite(scale)) continue;
            std::array<Bin, kBins> bins;
            for (std::uint32_t i = first; i < first + count; ++i) {
                const std::uint32_t triangle = bvh_.order[i];
                Bin& bin = bins[static_cast<std::size_t>(
                    bin_of(centroid(triangle)[axis], centroids.lower[axis], scale))];
                bin.bounds.extend(boxes_[triangle]);
                ++bin.count;
            }
            sweep(bins, axis, best);
        }
        return best;
    }

    static void sweep(const std::array<Bin, kBins>& bins, int axis, Split& best) {
        std::array<float, kBins> right_cost{};
        Bin right;
        for (int i = kBins - 1; i > 0; --i) {
            right.bounds.extend(bins[static_cast<std::size_t>(i)].bounds);
            right.count += bins[static_cast<std::size_t>(i)].count;
            right_cost[static_cast<std::size_t>(i)] =
                right.bounds.half_area() * static_cast<float>(right.count);
        }
        Bin left;
        const std::uint32_t total = right.count + bins[0].count;
        for (int i = 0; i + 1 < kBins; ++i) {
            left.bounds.extend(bins[static_cast<std::size_t>(i)].bounds);
            left.count += bins[static_cast<std::size_t>(i)].count;
            if (left.count == 0 || left.count == total) continue;
            const float cost = left.bounds.half_area() * static_cast<float>(left.count) +
                               right_cost[static_cast<std::size_t>(i) + 1];
            if (cost < best.cost) best = {cost, axis, i};
        }
    }

    std::uint32_t max_depth_;
    std::vector<Bounds> boxes_;
    BinaryBvh bvh_;
};

}  // namespace

BinaryBvh build_binary_bvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                           std::uint32_t max_depth) {
    UTSURI_CHECK_LE(static_cast<std::uint32_t>(std::bit_width(triangles.size())) + 1, max_depth);
    return Builder(positions, triangles, max_depth).build();
}

}  // namespace utsuri
