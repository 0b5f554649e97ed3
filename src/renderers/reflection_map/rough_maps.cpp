// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/rough_maps.h"

#include "renderers/reflection_map/capture_point.h"
#include "renderers/reflection_map/lobe_albedo.h"
#include "renderers/reflection_map/map_prefilter.h"

#include "base/check.h"
#include "base/error.h"

#include "interop/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace utsuri {
namespace {

RoughMapPlan placed(const Device& device, const SceneData& data, const RoughMapSettings& settings,
                    std::vector<interop::ProxyPlane>& proxy_planes) {
    RoughMapPlan plan = plan_rough_maps(data, settings.size);
    const std::uint64_t limit = device.summary().storage_range_bytes;
    if (plan.levels.empty()) return plan;
    const std::uint64_t bytes =
        std::max(plan.texels, MapPrefilter::source_texels(plan.largest_source())) * sizeof(glm::vec3);
    if (bytes > limit) {
        throw UsageError(
            "make maps for rough surfaces", fmt::format("of at most {} texels", settings.size),
            fmt::format("they need {} MiB and {} can see {} MiB of a buffer; use a smaller --map-size",
                        bytes >> 20, device.summary().name, limit >> 20));
    }
    for (std::uint32_t i = 0; i < plan.infos.size(); ++i) {
        interop::RoughMapInfo& info = plan.infos[i];
        if (info.levels == 0) continue;
        const glm::dvec3 point =
            settings.capture_point ? *settings.capture_point - data.origin : find_capture_point(data, i);
        info.capture_point = glm::vec3(point);
        if (settings.uses_proxies)
            info.proxy = add_proxy(proxy_planes, find_proxy(data, i, point, settings.proxy));
    }
    return plan;
}

}  // namespace

RoughMaps::RoughMaps(Device& device, const SceneData& data, const RoughMapSettings& settings)
    : device_(&device),
      settings_(settings),
      plan_(placed(device, data, settings, proxy_planes_)),
      infos_(make_buffer<interop::RoughMapInfo>(device, plan_.infos, "rough maps")),
      proxy_plane_buffer_(make_buffer<interop::ProxyPlane>(device, proxy_planes_, "planes of rough proxies")),
      levels_(make_buffer<interop::RoughLevel>(device, plan_.levels, "levels of rough maps")),
      texels_(device, std::max<std::uint64_t>(1, plan_.texels) * sizeof(glm::vec3), "texels of rough maps"),
      inverse_distances_(
          device, (settings.keeps_distances ? std::max<std::uint64_t>(1, plan_.texels) : 1) * sizeof(float),
          "inverse distances of rough maps"),
      lobe_albedos_(make_buffer<interop::LobeAlbedo>(
          device, plan_.levels.empty() ? std::vector<interop::LobeAlbedo>() : make_lobe_albedo_table(),
          "albedos of lobes")) {}

FrameCounts RoughMaps::capture(const GpuScene& scene, const LightCache& light, const RenderSettings& settings,
                               double& seconds_to_compile, Progress& progress) {
    FrameCounts counts;
    if (plan_.levels.empty()) return counts;
    const auto start = std::chrono::steady_clock::now();
    MapPrefilter prefilter(*device_, scene, light, {texels_, inverse_distances_, settings_.keeps_distances},
                           plan_.largest_source());
    prefilter.warm_up();
    seconds_to_compile += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (std::uint32_t i = 0; i < plan_.infos.size(); ++i) {
        if (progress.cancelled()) throw Interrupted();
        const interop::RoughMapInfo& info = plan_.infos[i];
        if (info.levels == 0) continue;
        const std::uint32_t source = plan_.source_sizes[i];
        // Any odd multiple keeps the samples of maps and picture apart; its faces count on.
        const FrameSettings frame{{},
                                  settings.seed ^ (0x85ebca6bu * (interop::ROUGH_MAP_FACES * i + 1)),
                                  std::min(settings.specular_depth, scene.specular_depth()),
                                  i};
        accumulate(counts, prefilter.capture(info.capture_point, source, frame, settings_.samples));
        for (std::uint32_t level = 0; level < info.levels; ++level) {
            const interop::RoughLevel& made = plan_.levels[info.first_level + level];
            const float roughness = plan_.roughness(i, level);
            counts.gpu_seconds +=
                prefilter.convolve({source, made.size, made.first_texel, roughness * roughness});
        }
        progress.update(i + 1, static_cast<std::uint32_t>(plan_.infos.size()));
    }
    return counts;
}

Bindings RoughMaps::bindings() const {
    return {{interop::BINDING_ROUGH_MAPS, &infos_},
            {interop::BINDING_ROUGH_PROXY_PLANES, &proxy_plane_buffer_},
            {interop::BINDING_ROUGH_LEVELS, &levels_},
            {interop::BINDING_ROUGH_TEXELS, &texels_},
            {interop::BINDING_ROUGH_INVERSE_DISTANCES, &inverse_distances_},
            {interop::BINDING_LOBE_ALBEDO, &lobe_albedos_}};
}

std::uint32_t RoughMaps::stride(std::uint32_t level) const {
    return plan_.levels[level].size + 2 * interop::ROUGH_MAP_BORDER;
}

std::uint64_t RoughMaps::first_texel(std::uint32_t level, std::uint32_t face) const {
    return plan_.levels[level].first_texel + std::uint64_t{face} * stride(level) * stride(level);
}

Image RoughMaps::face(std::uint32_t level, std::uint32_t face) const {
    Image image(stride(level), stride(level));
    texels_.download(std::as_writable_bytes(std::span(image.pixels)),
                     first_texel(level, face) * sizeof(glm::vec3));
    return image;
}

std::vector<float> RoughMaps::inverse_distances(std::uint32_t level, std::uint32_t face) const {
    UTSURI_CHECK(settings_.keeps_distances);
    std::vector<float> result(std::size_t{stride(level)} * stride(level));
    inverse_distances_.download(std::as_writable_bytes(std::span(result)),
                                first_texel(level, face) * sizeof(float));
    return result;
}

}  // namespace utsuri
