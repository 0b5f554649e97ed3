// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/map_preparation.h"

#include "interop/specialization.h"

#include <chrono>

namespace utsuri {

RoughMapSettings rough_map_settings(MapKind kind, const MapSettings& maps) {
    const bool uses_proxies = kind == MapKind::proxy || keeps_distances(kind);
    return {maps.size, maps.samples, maps.capture_point, uses_proxies, maps.proxy};
}

Specialization with_proxies(Specialization specialization, const ReflectionMaps& maps,
                            const RoughMaps& rough_maps) {
    const bool has_planes = !maps.proxy_planes().empty() || !rough_maps.proxy_planes().empty();
    specialization[interop::SPEC_HAS_PROXY_PLANES] = has_planes ? 1 : 0;
    return specialization;
}

void prepare_light_and_maps(const GpuScene& scene, FilledLight& filled, LightCache& light,
                            ReflectionMaps& maps, RoughMaps& rough_maps,
                            const KnownSurroundings& surroundings, const Camera& eye,
                            const RenderSettings& settings, RenderStatistics& statistics,
                            Progress& progress) {
    light.fill(scene, settings.seed, filled, progress);
    statistics.prepare_seconds += filled.seconds;
    statistics.compile_seconds += filled.compile_seconds;
    accumulate(statistics.prepare_counts, filled.counts);

    const auto start = std::chrono::steady_clock::now();
    double capture_compile_seconds = 0.0;
    accumulate(statistics.prepare_counts,
               maps.capture(scene, light, eye, settings, capture_compile_seconds, progress));
    accumulate(statistics.prepare_counts,
               rough_maps.capture(scene, light, settings, capture_compile_seconds, progress));
    if (surroundings.distances) {
        accumulate(statistics.prepare_counts,
                   surroundings.distances->capture(scene, capture_compile_seconds, progress));
    }
    if (surroundings.radiance) {
        accumulate(statistics.prepare_counts,
                   surroundings.radiance->capture(scene, light, capture_compile_seconds, progress));
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    statistics.prepare_seconds += seconds - capture_compile_seconds;
    statistics.compile_seconds += capture_compile_seconds;
}

}  // namespace utsuri
