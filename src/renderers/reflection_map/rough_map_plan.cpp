// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/rough_map_plan.h"

#include "renderers/reflection_map/map_prefilter.h"

#include "interop/shading.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace utsuri {
namespace {

/// Steps of perceptual roughness between levels, at most.
constexpr float kRoughnessStep = 0.125f;

/// Texels of a level over 1 / alpha: they are then half an alpha apart, and linear interpolation at the peak
/// of the lobe of a point is wrong by 3 % of it.
constexpr double kTexelsPerWidth = 4.0;
constexpr std::uint32_t kSmallestLevel = 4;

/// Texels of what is captured: so that lights a hundredth of the sphere in size are seen in detail.
constexpr std::uint32_t kSmallestSource = 32;

std::uint32_t level_size(float roughness, std::uint32_t most_size) {
    const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
    const double size = std::ceil(kTexelsPerWidth / alpha);
    if (size >= most_size) return most_size;
    return std::min(most_size, std::max(kSmallestLevel, static_cast<std::uint32_t>(size)));
}

/// A power of two, twice as fine as the level made of it.
std::uint32_t source_size(std::uint32_t finest_level, std::uint32_t most_size) {
    return std::min(std::bit_floor(most_size), std::max(kSmallestSource, std::bit_ceil(2 * finest_level)));
}

/// The materials of instances; an instance has one.
std::vector<std::optional<std::uint32_t>> instance_materials(const SceneData& data) {
    std::vector<std::optional<std::uint32_t>> materials(data.requirements.instances);
    for (const interop::TriangleInfo& info : data.triangle_infos)
        materials[info.instance] = info.material;
    return materials;
}

}  // namespace

std::uint32_t RoughMapPlan::largest_source() const {
    return source_sizes.empty() ? 0 : *std::max_element(source_sizes.begin(), source_sizes.end());
}

float RoughMapPlan::roughness(std::uint32_t instance, std::uint32_t level) const {
    const interop::RoughMapInfo& info = infos[instance];
    return info.levels > 1 ? info.least_roughness + static_cast<float>(level) / info.steps_per_unit
                           : info.least_roughness;
}

RoughMapPlan plan_rough_maps(const SceneData& data, std::uint32_t most_size) {
    RoughMapPlan plan;
    const auto materials = instance_materials(data);
    for (std::uint32_t i = 0; i < data.requirements.instances; ++i) {
        interop::RoughMapInfo info{};
        info.first_level = static_cast<std::uint32_t>(plan.levels.size());
        plan.source_sizes.push_back(0);
        const bool glossy = materials[i] && data.requirements.surfaces[*materials[i]].glossy;
        float span = 0.0f;
        if (glossy) {
            const RoughnessRange& range = data.requirements.roughness[*materials[i]];
            info.least_roughness = std::max(range.least, interop::SPECULAR_ROUGHNESS);
            span = range.most - info.least_roughness;
            info.levels = 1 + static_cast<std::uint32_t>(std::ceil(span / kRoughnessStep));
            info.steps_per_unit = info.levels > 1 ? static_cast<float>(info.levels - 1) / span : 0.0f;
        }
        plan.infos.push_back(info);
        for (std::uint32_t level = 0; level < info.levels; ++level) {
            const std::uint32_t size = level_size(plan.roughness(i, level), most_size);
            if (level == 0) plan.source_sizes[i] = source_size(size, most_size);
            plan.levels.push_back({static_cast<std::uint32_t>(plan.texels), size});
            plan.texels += prefiltered_texels(size);
        }
    }
    return plan;
}

std::uint64_t rough_map_bytes(const SceneData& data, std::uint32_t most_size) {
    const RoughMapPlan plan = plan_rough_maps(data, most_size);
    const std::uint32_t source = plan.largest_source();
    if (source == 0) return 0;
    return (plan.texels + MapPrefilter::source_texels(source)) * sizeof(glm::vec3) +
           Film::bytes(source, source);
}

}  // namespace utsuri
