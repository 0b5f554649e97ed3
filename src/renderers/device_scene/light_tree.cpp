// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/light_tree.h"

#include "renderers/device_scene/light_cluster.h"

#include "base/check.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace utsuri {
namespace {

constexpr std::size_t kBins = 12;

LightSummary summary_of(const TreeLight& light) {
    LightSummary summary{light.lower, light.upper, {}, light.both_sides, light.power};
    if (light.axis == glm::dvec3(0.0)) {
        summary.normals.angle = std::numbers::pi;
    } else {
        summary.normals = {light.axis, 0.0};
    }
    return summary;
}

glm::dvec3 middle_of(const TreeLight& light) {
    return 0.5 * (light.lower + light.upper);
}

class Builder {
  public:
    Builder(std::span<const TreeLight> lights, std::span<interop::LightInfo> infos, std::uint32_t first_light)
        : lights_(lights), infos_(infos), first_light_(first_light), order_(lights.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        for (const TreeLight& light : lights)
            total_ += light.power;
    }

    std::vector<interop::LightTreeNode> build() {
        if (order_.size() == 1) {
            infos_[0].path_length = 1;
            nodes_.push_back(
                {pack_cluster(summary_of(lights_[0]), total_, interop::LIGHT_CLUSTER_LEAF | first_light_),
                 {}});
        } else if (!order_.empty()) {
            build(order_, 0, 0);
        }
        return std::move(nodes_);
    }

  private:
    /// Some lights, and how a node refers to them.
    struct Child {
        LightSummary summary;
        std::uint32_t reference;
    };

    /// @param part of the order, permuted
    /// @param path to it
    Child build(std::span<std::uint32_t> part, std::uint32_t level, std::uint32_t path) {
        if (part.size() == 1) {
            infos_[part[0]].path = path;
            infos_[part[0]].path_length = level;
            return {summary_of(lights_[part[0]]), interop::LIGHT_CLUSTER_LEAF | (first_light_ + part[0])};
        }
        const auto node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        const std::size_t middle = split(part, level);
        const Child first = build(part.first(middle), level + 1, path);
        const Child second = build(part.subspan(middle), level + 1, path | 1u << level);
        nodes_[node] = {pack_cluster(first.summary, total_, first.reference),
                        pack_cluster(second.summary, total_, second.reference)};
        return {joined(first.summary, second.summary), node};
    }

    /// @returns how many lights of the part go to the first child, after putting them first
    std::size_t split(std::span<std::uint32_t> part, std::uint32_t level) const {
        const auto levels_left = interop::LIGHT_TREE_LEVELS - level;
        // A median split leaves at most half of them, rounded up, to each child.
        const bool has_room = std::bit_width(part.size() - 1) < levels_left;
        const std::optional<Cut> cut = has_room ? best_cut(part) : std::nullopt;
        if (!cut) return split_at_median(part);
        const auto second = std::partition(part.begin(), part.end(), [&](std::uint32_t light) {
            return bin_of(light, *cut) <= cut->last_bin;
        });
        return static_cast<std::size_t>(second - part.begin());
    }

    /// Bins along an axis, and the last one of the first child.
    struct Cut {
        int axis = 0;
        double lower = 0.0;
        double extent = 0.0;
        std::size_t last_bin = 0;
    };

    [[nodiscard]] std::size_t bin_of(std::uint32_t light, const Cut& cut) const {
        const double share = (middle_of(lights_[light])[cut.axis] - cut.lower) / cut.extent;
        return std::min(static_cast<std::size_t>(share * kBins), kBins - 1);
    }

    [[nodiscard]] std::optional<Cut> best_cut(std::span<const std::uint32_t> part) const {
        glm::dvec3 lower(std::numeric_limits<double>::infinity());
        glm::dvec3 upper(-std::numeric_limits<double>::infinity());
        for (const std::uint32_t light : part) {
            lower = glm::min(lower, middle_of(lights_[light]));
            upper = glm::max(upper, middle_of(lights_[light]));
        }
        std::optional<Cut> best;
        double least = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            Cut cut{axis, lower[axis], upper[axis] - lower[axis]};
            if (!(cut.extent > 0.0)) continue;
            const double cost = find_last_bin(part, cut);
            if (cost >= least) continue;
            least = cost;
            best = cut;
        }
        return best;
    }

    /// Sets the cut's last bin to that of least cost.
    /// @returns that cost
    double find_last_bin(std::span<const std::uint32_t> part, Cut& cut) const {
        std::array<LightSummary, kBins> bins{};
        for (const std::uint32_t light : part) {
            LightSummary& bin = bins[bin_of(light, cut)];
            bin = joined(bin, summary_of(lights_[light]));
        }
        std::array<double, kBins> second_cost{};
        LightSummary second;
        for (std::size_t i = kBins - 1; i > 0; --i) {
            second = joined(second, bins[i]);
            second_cost[i - 1] = second.power > 0.0 ? second.cost() : std::numeric_limits<double>::infinity();
        }
        double least = std::numeric_limits<double>::infinity();
        LightSummary first;
        for (std::size_t i = 0; i + 1 < kBins; ++i) {
            first = joined(first, bins[i]);
            if (first.power == 0.0) continue;
            const double cost = first.cost() + second_cost[i];
            if (cost >= least) continue;
            least = cost;
            cut.last_bin = i;
        }
        return least;
    }

    /// Where lights are in one place, or too deep down the tree: along the axis of the largest extent.
    std::size_t split_at_median(std::span<std::uint32_t> part) const {
        glm::dvec3 lower = middle_of(lights_[part[0]]);
        glm::dvec3 upper = lower;
        for (const std::uint32_t light : part) {
            lower = glm::min(lower, middle_of(lights_[light]));
            upper = glm::max(upper, middle_of(lights_[light]));
        }
        const glm::dvec3 extent = upper - lower;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        const std::size_t middle = part.size() / 2;
        std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(middle), part.end(),
                         [&](std::uint32_t a, std::uint32_t b) {
                             const double x = middle_of(lights_[a])[axis];
                             const double y = middle_of(lights_[b])[axis];
                             return x != y ? x < y : a < b;
                         });
        return middle;
    }

    std::span<const TreeLight> lights_;
    std::span<interop::LightInfo> infos_;
    std::uint32_t first_light_;
    std::vector<std::uint32_t> order_;
    double total_ = 0.0;
    std::vector<interop::LightTreeNode> nodes_;
};

}  // namespace

std::vector<interop::LightTreeNode> build_light_tree(std::span<const TreeLight> lights,
                                                     std::span<interop::LightInfo> infos,
                                                     std::uint32_t first_light) {
    UTSURI_CHECK_EQ(lights.size(), infos.size());
    UTSURI_CHECK_LE(first_light + lights.size(), std::size_t{interop::LIGHT_CLUSTER_INDEX});
    return Builder(lights, infos, first_light).build();
}

}  // namespace utsuri
