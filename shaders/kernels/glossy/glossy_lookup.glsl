// SPDX-License-Identifier: Apache-2.0
// What a glossy lobe of a drawn surface reflects, from maps convolved with lobes: the split sum (Karis 2013).
#ifndef UTSURI_KERNELS_GLOSSY_GLOSSY_LOOKUP
#define UTSURI_KERNELS_GLOSSY_GLOSSY_LOOKUP

#include "kernels/glossy/glossy_distance.glsl"
#include "kernels/maps/proxies.glsl"
#include "kernels/scene/scene_bindings.glsl"
#include "lib/probe_blend.glsl"
#include "lib/surface.glsl"

layout(constant_id = SPEC_MOST_GLOSSY_PROBES) const uint MOST_GLOSSY_PROBES = 1u;

layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_MAPS) readonly restrict buffer GlossyMaps { GlossyMapInfo glossy_maps[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_PROBES) readonly restrict buffer GlossyProbes { GlossyProbe glossy_probes[]; };

/// The direction from the capture point that stands for the mirrored one. Sphere maps are in eye space: glossy lobes have
/// none, and take what is far.
vec3 glossy_map_direction(Surface surface, GlossyProbe probe, GlossyLobe lobe, vec3 wi, vec3 interpolated) {
    if (MAP_KIND == MAP_KIND_PROXY)
        return direction_to(leave_proxy(surface.position, wi, probe.proxy), probe.capture_point, wi);
    if (MAP_KIND == MAP_KIND_DISTANCE) return direction_of_glossy_hit(lobe, surface.position - probe.capture_point, wi);
    // Opposite vectors may cancel; nothing can be interpolated there.
    return MAP_KIND == MAP_KIND_POLYGON && interpolated != vec3(0.0) ? interpolated : wi;
}

GlossyLobe glossy_lobe(GlossyMapInfo map, GlossyProbe probe, float alpha) {
    float position = (sqrt(alpha) - map.least_roughness) * map.steps_per_unit;
    position = clamp(position, 0.0, float(map.levels - 1u));
    uint below = uint(position);
    uint above = min(below + 1u, map.levels - 1u);
    return GlossyLobe(glossy_levels[probe.first_level + below], glossy_levels[probe.first_level + above],
                     position - float(below));
}

vec3 probe_radiance(Surface surface, GlossyMapInfo map, uint index, vec3 wi, vec3 interpolated) {
    GlossyProbe probe = glossy_probes[index];
    GlossyLobe lobe = glossy_lobe(map, probe, surface.alpha);
    vec3 direction = glossy_map_direction(surface, probe, lobe, wi, interpolated);
    vec3 radiance = glossy_level(lobe.below, direction);
    if (lobe.share == 0.0) return radiance;
    return mix(radiance, glossy_level(lobe.above, direction), lobe.share);
}

float lobe_distance_to_probe(Surface surface, uint index, vec3 wi) {
    return lobe_distance(surface.position - glossy_probes[index].capture_point, wi, surface.alpha);
}

/// @param interpolated the reflection vector found per vertex, for MAP_KIND_POLYGON
vec3 glossy_radiance(Surface surface, vec3 wo, vec3 interpolated) {
    GlossyMapInfo map = glossy_maps[triangle_infos[surface.triangle].instance];
    vec3 wi = reflect(-wo, surface.ns);
    if (MOST_GLOSSY_PROBES == 1u) return probe_radiance(surface, map, map.first_probe, wi, interpolated);
    float nearest = INFINITY;
    for (uint i = 0u; i < map.probes; ++i) nearest = min(nearest, lobe_distance_to_probe(surface, map.first_probe + i, wi));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint i = map.first_probe; i < map.first_probe + map.probes; ++i) {
        float weight = blend_weight(lobe_distance_to_probe(surface, i, wi), nearest, map.blend_width);
        if (weight == 0.0) continue;
        sum += weight * probe_radiance(surface, map, i, wi, interpolated);
        weights += weight;
    }
    return sum / weights;
}

#endif
