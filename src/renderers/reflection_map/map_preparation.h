// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/light_cache.h"
#include "renderers/reflection_map/distance_maps.h"
#include "renderers/reflection_map/reflection_maps.h"
#include "renderers/reflection_map/reflector_drawer.h"
#include "renderers/reflection_map/rough_maps.h"

namespace utsuri {

/// What rough lobes reflect beside maps of a kind.
RoughMapSettings rough_map_settings(MapKind kind, const MapSettings& maps);

/// Constants of kernels that look maps up, told what their proxies are.
Specialization with_proxies(Specialization specialization, const ReflectionMaps& maps,
                            const RoughMaps& rough_maps);

/// Fills a light cache, captures maps lit from it, and adds what that took to the statistics.
/// @param filled is filled by the first renderer that needs it; its cost counts as if it had been filled here
/// @param distances captured too, if not null
/// @param eye whose axes orient sphere maps
void prepare_light_and_maps(const GpuScene& scene, FilledLight& filled, LightCache& light,
                            ReflectionMaps& maps, RoughMaps& rough_maps, DistanceMaps* distances,
                            const Camera& eye, const RenderSettings& settings, RenderStatistics& statistics,
                            Progress& progress);

}  // namespace utsuri
