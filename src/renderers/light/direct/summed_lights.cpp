// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/summed_lights.h"

#include "renderers/device_scene/scene_triangles.h"
#include "renderers/device_scene/triangle_frame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <queue>
#include <tuple>

namespace utsuri {
namespace {

/// Summing more lights than this at every point would cost as much as the rays that tell their shadows.
constexpr std::size_t kMostSummedLights = 4096;

bool is_light(std::uint32_t reference) {
    return (reference & interop::LIGHT_CLUSTER_LEAF) != 0;
}

std::vector<interop::LightCluster> children(const SceneData& data, std::uint32_t reference) {
    const interop::LightTreeNode& node = data.light_tree[reference & interop::LIGHT_CLUSTER_INDEX];
    std::vector<interop::LightCluster> result;
    for (const interop::LightCluster& child : {node.first, node.second}) {
        if (child.power > 0.0f) result.push_back(child);
    }
    return result;
}

/// Balls that are farther apart than this share of what they would be if they touched are two lamps.
constexpr float kGap = 1.25f;

bool are_apart(const interop::LightCluster& a, const interop::LightCluster& b) {
    return glm::distance(a.centre, b.centre) > kGap * (a.radius + b.radius);
}

/// Divides the tree into lamps.
class TreeCut {
  public:
    explicit TreeCut(const SceneData& data) : data_(data), is_lamp_(data.light_tree.size(), false) {
        // Children follow their parents.
        for (std::size_t node = data.light_tree.size(); node-- > 0;) {
            const auto parts = children(data, static_cast<std::uint32_t>(node));
            is_lamp_[node] =
                std::ranges::all_of(parts, [&](const auto& part) { return is_lamp(part.child); }) &&
                (parts.size() < 2 || !are_apart(parts[0], parts[1]));
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> divide(std::size_t most) const {
        std::vector<std::uint32_t> lamps;
        if (data_.light_tree.empty()) return lamps;
        std::priority_queue<Part> parts;
        parts.push({1.0f, 0});
        while (!parts.empty()) {
            const Part part = parts.top();
            parts.pop();
            if (is_lamp(part.reference) || parts.size() + lamps.size() + 2 > most) {
                lamps.push_back(part.reference);
                continue;
            }
            for (const interop::LightCluster& child : children(data_, part.reference))
                parts.push({child.power * child.radius, child.child});
        }
        return lamps;
    }

  private:
    /// A part of the tree. Those come first that shine most and are widest, of equal ones the first in the
    /// tree.
    struct Part {
        float weight;
        std::uint32_t reference;

        friend bool operator<(const Part& a, const Part& b) {
            return std::tie(a.weight, b.reference) < std::tie(b.weight, a.reference);
        }
    };

    [[nodiscard]] bool is_lamp(std::uint32_t reference) const {
        return is_light(reference) || is_lamp_[reference & interop::LIGHT_CLUSTER_INDEX];
    }

    const SceneData& data_;
    std::vector<bool> is_lamp_;  ///< of each node: there is no gap in it
};

class Lister {
  public:
    Lister(const SceneData& data, const LightPieces& pieces) : data_(data), pieces_(pieces) {}

    void add_group(std::uint32_t reference) {
        add_lights(reference);
        result_.groups.push_back({reference, has_extent(reference) ? interop::NONE : 1});
    }
    [[nodiscard]] SummedLights take() {
        result_.plain_triangles = static_cast<std::uint32_t>(result_.lights.size());
        result_.lights.insert(result_.lights.end(), textured_.begin(), textured_.end());
        result_.triangles = static_cast<std::uint32_t>(result_.lights.size());
        result_.lights.insert(result_.lights.end(), others_.begin(), others_.end());
        return std::move(result_);
    }

  private:
    [[nodiscard]] bool has_extent(std::uint32_t reference) const {
        if (!is_light(reference)) return true;
        const std::uint32_t type = data_.lights[reference & interop::LIGHT_CLUSTER_INDEX].type;
        return type == interop::LIGHT_TRIANGLE || type == interop::LIGHT_ENVIRONMENT;
    }

    void add_lights(std::uint32_t reference) {
        std::vector<std::uint32_t> parts{reference};
        while (!parts.empty()) {
            const std::uint32_t part = parts.back();
            parts.pop_back();
            if (is_light(part)) {
                add_light(part & interop::LIGHT_CLUSTER_INDEX);
                continue;
            }
            for (const interop::LightCluster& child : children(data_, part))
                parts.push_back(child.child);
        }
    }

    void add_light(std::uint32_t index) {
        const interop::LightInfo& info = data_.lights[index];
        interop::SummedLight light{};
        light.light = index;
        light.group = static_cast<std::uint32_t>(result_.groups.size());
        light.first_piece = pieces_.first[index];
        if (info.type != interop::LIGHT_TRIANGLE) {
            others_.push_back(light);
            return;
        }
        const Corners corners = corners_of(data_, info.triangle);
        const interop::MaterialInfo& material = data_.materials[data_.triangle_infos[info.triangle].material];
        const double size = TriangleFrame(corners).longest_edge();
        light.middle = glm::vec3((corners[0] + corners[1] + corners[2]) / 3.0);
        light.size_squared = static_cast<float>(size * size);
        light.area = glm::vec3(0.5 * doubled_area(corners));
        light.v0 = glm::vec3(corners[0]);
        light.v1 = glm::vec3(corners[1]);
        light.v2 = glm::vec3(corners[2]);
        light.radiance = material.emissive;
        light.is_double_sided = material.double_sided;
        (light.first_piece == interop::NONE ? result_.lights : textured_).push_back(light);
    }

    const SceneData& data_;
    const LightPieces& pieces_;
    SummedLights result_;
    std::vector<interop::SummedLight> textured_;
    std::vector<interop::SummedLight> others_;
};

}  // namespace

bool sums_lights(const SceneData& data) {
    return data.lights.size() <= kMostSummedLights && data.infinite_lights() < interop::MOST_LIGHT_GROUPS;
}

SummedLights list_summed_lights(const SceneData& data, const LightPieces& pieces) {
    Lister lister(data, pieces);
    const std::uint32_t infinite = data.infinite_lights();
    for (std::uint32_t light = 0; light < infinite; ++light)
        lister.add_group(interop::LIGHT_CLUSTER_LEAF | light);
    for (const std::uint32_t part : TreeCut(data).divide(interop::MOST_LIGHT_GROUPS - infinite))
        lister.add_group(part);
    return lister.take();
}

}  // namespace utsuri
