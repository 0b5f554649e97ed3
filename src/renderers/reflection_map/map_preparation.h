// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/light_cache.h"
#include "renderers/reflection_map/distance_maps.h"
#include "renderers/reflection_map/radiance_bounds.h"
#include "renderers/reflection_map/reflection_maps.h"
#include "renderers/reflection_map/rough_maps.h"

namespace utsuri {

/// What rough lobes reflect beside maps of a kind.
RoughMapSettings rough_map_settings(MapKind kind, const MapSettings& maps);

/// Constants of kernels that look maps up, told what their proxies are.
Specialization with_proxies(Specialization specialization, const ReflectionMaps& maps,
                            const RoughMaps& rough_maps);

/// What is known of what surrounds surfaces that reflect, whatever the eye; null where nothing needs it.
struct KnownSurroundings {
    RoughMaps* rough = nullptr;
    DistanceMaps* distances = nullptr;
    RadianceBounds* radiance = nullptr;
};

/// Fills a light cache, captures surroundings lit from it, and adds what that took to the statistics.
/// @param filled is filled by the first renderer that needs it; its cost counts as if it had been filled here
void prepare_light_and_surroundings(const GpuScene& scene, FilledLight& filled, LightCache& light,
                                    const KnownSurroundings& surroundings, const RenderSettings& settings,
                                    RenderStatistics& statistics, Progress& progress);

}  // namespace utsuri
