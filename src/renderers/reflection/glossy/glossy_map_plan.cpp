// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/glossy/glossy_map_plan.h"

#include "renderers/device_scene/scene_triangles.h"
#include "renderers/reflection/glossy/map_prefilter.h"

#include "interop/shading.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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

interop::GlossyMapInfo describe_levels(const RoughnessRange& range) {
    interop::GlossyMapInfo info{};
    info.least_roughness = std::max(range.least, interop::SPECULAR_ROUGHNESS);
    const float span = range.most - info.least_roughness;
    info.levels = 1 + static_cast<std::uint32_t>(std::ceil(span / kRoughnessStep));
    info.steps_per_unit = info.levels > 1 ? static_cast<float>(info.levels - 1) / span : 0.0f;
    return info;
}

/// Half the least distance between two capture points: at one of them, a lobe along the normal knows no
/// other.
float blend_width(const std::vector<Probe>& probes, const interop::ProbeRange& range) {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < range.count; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            least = std::min(least, glm::distance(probes[range.first + i].capture_point,
                                                  probes[range.first + j].capture_point));
        }
    }
    return static_cast<float>(0.5 * least);
}

/// The maps of one more probe of an instance.
void add_levels(GlossyMapPlan& plan, std::uint32_t instance, const glm::dvec3& capture_point,
                std::uint32_t most_size) {
    plan.probes.push_back({glm::vec3(capture_point), {}, static_cast<std::uint32_t>(plan.levels.size())});
    for (std::uint32_t level = 0; level < plan.infos[instance].levels; ++level) {
        const std::uint32_t size = level_size(plan.roughness(instance, level), most_size);
        plan.levels.push_back({static_cast<std::uint32_t>(plan.texels), size});
        plan.texels += prefiltered_texels(size);
    }
}

/// With a capture point for each glossy instance, wherever that is.
GlossyMapPlan plan_from_one_point(const SceneData& data, std::uint32_t most_size) {
    std::vector<Probe> probes;
    for (std::uint32_t i = 0; i < data.requirements.glossy_instances.size(); ++i)
        probes.push_back({i, glm::dvec3(0.0)});
    return plan_glossy_maps(data, most_size, probes);
}

}  // namespace

std::uint32_t GlossyMapPlan::largest_source() const {
    return source_sizes.empty() ? 0 : *std::max_element(source_sizes.begin(), source_sizes.end());
}

float GlossyMapPlan::roughness(std::uint32_t instance, std::uint32_t level) const {
    const interop::GlossyMapInfo& info = infos[instance];
    return info.levels > 1 ? info.least_roughness + static_cast<float>(level) / info.steps_per_unit
                           : info.least_roughness;
}

std::uint32_t GlossyMapPlan::most_probes() const {
    std::uint32_t most = 1;
    for (const interop::GlossyMapInfo& info : infos)
        most = std::max(most, info.probes);
    return most;
}

GlossyMapPlan plan_glossy_maps(const SceneData& data, std::uint32_t most_size,
                               const std::vector<Probe>& probes) {
    GlossyMapPlan plan;
    plan.infos.resize(data.requirements.instances);
    plan.source_sizes.resize(data.requirements.instances);
    const std::vector<std::uint32_t>& glossy = data.requirements.glossy_instances;
    const std::vector<interop::ProbeRange> ranges = probe_ranges(probes, glossy.size());
    for (std::size_t r = 0; r < glossy.size(); ++r) {
        const std::uint32_t instance = glossy[r];
        plan.infos[instance] = describe_levels(data.requirements.roughness[material_of(data, instance)]);
        plan.infos[instance].first_probe = ranges[r].first;
        plan.infos[instance].probes = ranges[r].count;
        plan.infos[instance].blend_width = blend_width(probes, ranges[r]);
        const std::uint32_t finest = level_size(plan.roughness(instance, 0), most_size);
        plan.source_sizes[instance] = source_size(finest, most_size);
        for (std::uint32_t probe = 0; probe < ranges[r].count; ++probe)
            add_levels(plan, instance, probes[ranges[r].first + probe].capture_point, most_size);
    }
    return plan;
}

std::uint64_t glossy_map_bytes(const SceneData& data, std::uint32_t most_size) {
    const GlossyMapPlan plan = plan_from_one_point(data, most_size);
    const std::uint32_t source = plan.largest_source();
    if (source == 0) return 0;
    return (plan.texels + MapPrefilter::source_texels(source)) * sizeof(glm::vec3) +
           Film::bytes(source, source);
}

std::uint64_t glossy_distance_bytes(const SceneData& data, std::uint32_t most_size) {
    const GlossyMapPlan plan = plan_from_one_point(data, most_size);
    const std::uint32_t source = plan.largest_source();
    return source == 0 ? 0 : (plan.texels + MapPrefilter::source_texels(source)) * sizeof(float);
}

}  // namespace utsuri
