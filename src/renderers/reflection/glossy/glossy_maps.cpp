// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/glossy/glossy_maps.h"

#include "renderers/reflection/glossy/map_prefilter.h"

#include "base/check.h"
#include "base/error.h"
#include "base/stopwatch.h"

#include "interop/bindings.h"

#include <fmt/format.h>

#include <algorithm>

namespace utsuri {
namespace {

/// In bytes.
std::uint64_t largest_buffer(const GlossyMapPlan& plan) {
    return std::max(plan.texels, MapPrefilter::source_texels(plan.largest_source())) * sizeof(glm::vec3);
}

GlossyMapPlan placed(const Device& device, const SceneData& data, const GlossyMapSettings& settings,
                     std::vector<interop::ProxyPlane>& proxy_planes) {
    // Lobes are traced: traced_lobe.glsl.
    if (settings.kind == MapKind::hybrid) return {};
    const std::vector<std::uint32_t>& glossy = data.requirements.glossy_instances;
    const std::vector<Probe> probes =
        place_probes(data, glossy, settings.kind, {settings.most_probes, settings.capture_point});
    GlossyMapPlan plan = plan_glossy_maps(data, settings.size, probes);
    const std::uint64_t limit = device.summary().storage_range_bytes;
    if (plan.levels.empty()) return plan;
    for (std::uint32_t size = settings.size / 2;
         settings.shares_room && largest_buffer(plan) > limit && size > 0; size /= 2)
        plan = plan_glossy_maps(data, size, probes);
    const std::uint64_t bytes = largest_buffer(plan);
    if (bytes > limit) {
        throw UsageError(
            "make maps for glossy surfaces",
            fmt::format("of at most {} texels from {} capture points", settings.size, probes.size()),
            fmt::format("they need {} MiB and {} can see {} MiB of a buffer; use a smaller --map-size{}",
                        bytes >> 20, device.summary().name, limit >> 20,
                        settings.most_probes > 1 ? " or fewer --probes" : ""));
    }
    if (settings.kind != MapKind::proxy) return plan;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        plan.probes[i].proxy = add_proxy(proxy_planes, find_proxy(data, glossy[probes[i].reflector],
                                                                  probes[i].capture_point, settings.proxy));
    }
    return plan;
}

}  // namespace

GlossyMaps::GlossyMaps(Device& device, const SceneData& data, const GlossyMapSettings& settings,
                       std::vector<interop::ProxyPlane>& proxy_planes)
    : device_(&device),
      settings_(settings),
      plan_(placed(device, data, settings, proxy_planes)),
      infos_(make_buffer<interop::GlossyMapInfo>(device, plan_.infos, "glossy maps")),
      probes_(make_buffer<interop::GlossyProbe>(device, plan_.probes, "probes of glossy maps")),
      levels_(make_buffer<interop::GlossyLevel>(device, plan_.levels, "levels of glossy maps")),
      texels_(device, std::max<std::uint64_t>(1, plan_.texels) * sizeof(glm::vec3), "texels of glossy maps"),
      inverse_distances_(
          device,
          (keeps_distances(settings.kind) ? std::max<std::uint64_t>(1, plan_.texels) : 1) * sizeof(float),
          "inverse distances of glossy maps") {}

FrameCounts GlossyMaps::capture(const GpuScene& scene, const SurfaceLight& light,
                                const RenderSettings& settings, double& seconds_to_compile,
                                Progress& progress) {
    FrameCounts counts;
    if (plan_.levels.empty()) return counts;
    const Stopwatch stopwatch;
    MapPrefilter prefilter(*device_, scene, light,
                           {texels_, inverse_distances_, keeps_distances(settings_.kind)},
                           plan_.largest_source());
    prefilter.warm_up();
    seconds_to_compile += stopwatch.seconds();
    const auto instances = static_cast<std::uint32_t>(plan_.infos.size());
    for (std::uint32_t i = 0; i < instances; ++i) {
        for (std::uint32_t probe = 0; probe < plan_.infos[i].probes; ++probe) {
            if (progress.cancelled()) throw Interrupted();
            // The factor is odd, so that different probes begin at different seeds, none of them at the
            // picture's; their faces count on.
            const std::uint32_t number = interop::GLOSSY_MAP_FACES * (probe * instances + i) + 1;
            const FrameSettings frame{{},
                                      settings.seed ^ (0x85ebca6bu * number),
                                      std::min(settings.max_depth, scene.max_depth()),
                                      i};
            accumulate(counts, capture(prefilter, plan_.infos[i].first_probe + probe, frame));
        }
        progress.update(i + 1, instances);
    }
    return counts;
}

FrameCounts GlossyMaps::capture(MapPrefilter& prefilter, std::uint32_t probe, const FrameSettings& frame) {
    const std::uint32_t instance = frame.excluded_instance;
    const std::uint32_t source = plan_.source_sizes[instance];
    FrameCounts counts =
        prefilter.capture(plan_.probes[probe].capture_point, source, frame, settings_.samples);
    for (std::uint32_t level = 0; level < plan_.infos[instance].levels; ++level) {
        const interop::GlossyLevel& made = plan_.levels[plan_.probes[probe].first_level + level];
        const float roughness = plan_.roughness(instance, level);
        counts.gpu_seconds +=
            prefilter.convolve({source, made.size, made.first_texel, roughness * roughness, 0, 0});
    }
    return counts;
}

Bindings GlossyMaps::bindings() const {
    return {{interop::BINDING_GLOSSY_MAPS, &infos_},
            {interop::BINDING_GLOSSY_PROBES, &probes_},
            {interop::BINDING_GLOSSY_LEVELS, &levels_},
            {interop::BINDING_GLOSSY_TEXELS, &texels_},
            {interop::BINDING_GLOSSY_INVERSE_DISTANCES, &inverse_distances_}};
}

std::uint32_t GlossyMaps::stride(std::uint32_t level) const {
    return plan_.levels[level].size + 2 * interop::GLOSSY_MAP_BORDER;
}

std::uint64_t GlossyMaps::first_texel(std::uint32_t level, std::uint32_t face) const {
    return plan_.levels[level].first_texel + std::uint64_t{face} * stride(level) * stride(level);
}

Image GlossyMaps::face(std::uint32_t level, std::uint32_t face) const {
    Image image(stride(level), stride(level));
    texels_.download(std::as_writable_bytes(std::span(image.pixels)),
                     first_texel(level, face) * sizeof(glm::vec3));
    return image;
}

std::vector<float> GlossyMaps::inverse_distances(std::uint32_t level, std::uint32_t face) const {
    UTSURI_CHECK(keeps_distances(settings_.kind));
    std::vector<float> result(std::size_t{stride(level)} * stride(level));
    inverse_distances_.download(std::as_writable_bytes(std::span(result)),
                                first_texel(level, face) * sizeof(float));
    return result;
}

}  // namespace utsuri
