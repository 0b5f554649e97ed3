// SPDX-License-Identifier: Apache-2.0
// What a rough lobe of a drawn surface reflects, from maps convolved with lobes: the split sum (Karis 2013).
#ifndef UTSURI_KERNELS_GLOSSY_ROUGH_LOOKUP
#define UTSURI_KERNELS_GLOSSY_ROUGH_LOOKUP

#include "kernels/glossy/rough_distance.glsl"
#include "kernels/maps/proxies.glsl"
#include "kernels/scene/scene_bindings.glsl"
#include "lib/probe_blend.glsl"
#include "lib/surface.glsl"

layout(constant_id = SPEC_MOST_ROUGH_PROBES) const uint MOST_ROUGH_PROBES = 1u;

layout(scalar, set = METHOD_SET, binding = BINDING_ROUGH_MAPS) readonly restrict buffer RoughMaps { RoughMapInfo rough_maps[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_ROUGH_PROBES) readonly restrict buffer RoughProbes { RoughProbe rough_probes[]; };

/// The direction from the capture point that stands for the mirrored one. Sphere maps are in eye space: rough lobes have
/// none, and take what is far.
vec3 rough_direction(Surface surface, RoughProbe probe, RoughLobe lobe, vec3 wi, vec3 interpolated) {
    if (MAP_KIND == MAP_KIND_PROXY)
        return direction_to(leave_proxy(surface.position, wi, probe.proxy), probe.capture_point, wi);
    if (MAP_KIND == MAP_KIND_DISTANCE) return direction_of_rough_hit(lobe, surface.position - probe.capture_point, wi);
    // Opposite vectors may cancel; nothing can be interpolated there.
    return MAP_KIND == MAP_KIND_POLYGON && interpolated != vec3(0.0) ? interpolated : wi;
}

RoughLobe rough_lobe(RoughMapInfo map, RoughProbe probe, float alpha) {
    float position = (sqrt(alpha) - map.least_roughness) * map.steps_per_unit;
    position = clamp(position, 0.0, float(map.levels - 1u));
    uint below = uint(position);
    uint above = min(below + 1u, map.levels - 1u);
    return RoughLobe(rough_levels[probe.first_level + below], rough_levels[probe.first_level + above],
                     position - float(below));
}

vec3 probe_radiance(Surface surface, RoughMapInfo map, uint index, vec3 wi, vec3 interpolated) {
    RoughProbe probe = rough_probes[index];
    RoughLobe lobe = rough_lobe(map, probe, surface.alpha);
    vec3 direction = rough_direction(surface, probe, lobe, wi, interpolated);
    vec3 radiance = rough_level(lobe.below, direction);
    if (lobe.share == 0.0) return radiance;
    return mix(radiance, rough_level(lobe.above, direction), lobe.share);
}

float lobe_passes_probe(Surface surface, uint index, vec3 wi) {
    return lobe_passes_at(surface.position - rough_probes[index].capture_point, wi, surface.alpha);
}

/// @param interpolated the reflection vector found per vertex, for MAP_KIND_POLYGON
vec3 rough_radiance(Surface surface, vec3 wo, vec3 interpolated) {
    RoughMapInfo map = rough_maps[triangle_infos[surface.triangle].instance];
    vec3 wi = reflect(-wo, surface.ns);
    if (MOST_ROUGH_PROBES == 1u) return probe_radiance(surface, map, map.first_probe, wi, interpolated);
    float nearest = INFINITY;
    for (uint i = 0u; i < map.probes; ++i) nearest = min(nearest, lobe_passes_probe(surface, map.first_probe + i, wi));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint i = map.first_probe; i < map.first_probe + map.probes; ++i) {
        float weight = blend_weight(lobe_passes_probe(surface, i, wi), nearest, map.blend_width);
        if (weight == 0.0) continue;
        sum += weight * probe_radiance(surface, map, i, wi, interpolated);
        weights += weight;
    }
    return sum / weights;
}

#endif
