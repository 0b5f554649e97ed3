// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/map_preparation.h"

#include "interop/specialization.h"

#include <algorithm>
#include <chrono>

namespace utsuri {

RoughMapSettings rough_map_settings(MapKind kind, const MapSettings& maps) {
    const bool uses_proxies = kind == MapKind::proxy || keeps_distances(kind);
    // Of lobes only the sharpest would see finer maps than that.
    const std::uint32_t size = maps.fitted ? std::min(maps.size, MapSettings().size) : maps.size;
    return {size, maps.samples, maps.capture_point, uses_proxies, maps.proxy};
}

Specialization with_proxies(Specialization specialization, const ReflectionMaps& maps,
                            const RoughMaps& rough_maps) {
    const bool has_planes = !maps.proxy_planes().empty() || !rough_maps.proxy_planes().empty();
    specialization[interop::SPEC_HAS_PROXY_PLANES] = has_planes ? 1 : 0;
    return specialization;
}

void prepare_light_and_surroundings(const GpuScene& scene, FilledLight& filled, LightCache& light,
                                    const KnownSurroundings& surroundings, const RenderSettings& settings,
                                    RenderStatistics& statistics, Progress& progress) {
    light.fill(scene, settings.seed, filled, progress);
    statistics.prepare_seconds += filled.seconds;
    statistics.compile_seconds += filled.compile_seconds;
    accumulate(statistics.prepare_counts, filled.counts);

    const auto start = std::chrono::steady_clock::now();
    double compile_seconds = 0.0;
    FrameCounts& counts = statistics.prepare_counts;
    if (surroundings.rough)
        accumulate(counts, surroundings.rough->capture(scene, light, settings, compile_seconds, progress));
    if (surroundings.distances)
        accumulate(counts, surroundings.distances->capture(scene, compile_seconds, progress));
    if (surroundings.radiance)
        accumulate(counts, surroundings.radiance->capture(scene, light, compile_seconds, progress));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    statistics.prepare_seconds += seconds - compile_seconds;
    statistics.compile_seconds += compile_seconds;
}

}  // namespace utsuri
