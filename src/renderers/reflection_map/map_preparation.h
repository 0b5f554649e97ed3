// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/light_cache.h"
#include "renderers/reflection_map/distance_maps.h"
#include "renderers/reflection_map/radiance_bounds.h"
#include "renderers/reflection_map/reflection_maps.h"
#include "renderers/reflection_map/reflector_drawer.h"
#include "renderers/reflection_map/rough_maps.h"

namespace utsuri {

/// What rough lobes reflect beside maps of a kind.
RoughMapSettings rough_map_settings(MapKind kind, const MapSettings& maps);

/// Constants of kernels that look maps up, told what their proxies are.
Specialization with_proxies(Specialization specialization, const ReflectionMaps& maps,
                            const RoughMaps& rough_maps);

/// What is known of what surrounds reflectors; null where nothing needs it.
struct KnownSurroundings {
    DistanceMaps* distances = nullptr;
    RadianceBounds* radiance = nullptr;
};

/// Fills a light cache, captures maps lit from it, and adds what that took to the statistics.
/// @param filled is filled by the first renderer that needs it; its cost counts as if it had been filled here
/// @param surroundings captured too
/// @param eye whose axes orient sphere maps
void prepare_light_and_maps(const GpuScene& scene, FilledLight& filled, LightCache& light,
                            ReflectionMaps& maps, RoughMaps& rough_maps,
                            const KnownSurroundings& surroundings, const Camera& eye,
                            const RenderSettings& settings, RenderStatistics& statistics, Progress& progress);

}  // namespace utsuri
