// SPDX-License-Identifier: Apache-2.0
// What a rough lobe of a drawn surface reflects, from maps convolved with lobes: the split sum (Karis 2013).
#include "interop/rough_map.h"
#include "interop/reflection.h"
#include "lib/cube.glsl"
#include "lib/probe_blend.glsl"
#include "lib/proxy.glsl"

layout(constant_id = SPEC_MAP_KIND) const uint MAP_KIND = MAP_KIND_POLYGON;
layout(constant_id = SPEC_HAS_PROXY_PLANES) const uint HAS_PROXY_PLANES = 0u;
layout(constant_id = SPEC_MOST_ROUGH_PROBES) const uint MOST_ROUGH_PROBES = 1u;

layout(scalar, binding = BINDING_ROUGH_MAPS) readonly restrict buffer RoughMaps { RoughMapInfo rough_maps[]; };
layout(scalar, binding = BINDING_ROUGH_PROBES) readonly restrict buffer RoughProbes { RoughProbe rough_probes[]; };
layout(scalar, binding = BINDING_ROUGH_LEVELS) readonly restrict buffer RoughLevels { RoughLevel rough_levels[]; };
layout(scalar, binding = BINDING_ROUGH_TEXELS) readonly restrict buffer RoughTexels { vec3 rough_texels[]; };
layout(scalar, binding = BINDING_ROUGH_INVERSE_DISTANCES) readonly restrict buffer RoughInverseDistances {
    float rough_inverse_distances[];
};
layout(scalar, binding = BINDING_LOBE_ALBEDO) readonly restrict buffer LobeAlbedos { LobeAlbedo lobe_albedos[]; };
layout(scalar, binding = BINDING_ROUGH_PROXY_PLANES) readonly restrict buffer RoughProxyPlanes {
    ProxyPlane rough_proxy_planes[];
};

/// The levels next to a roughness.
struct RoughLobe {
    RoughLevel below;
    RoughLevel above;
    float share;  ///< of the level above; 0: it is none
};

/// Four texels about a direction: that of least coordinates, and where from its centre on the direction points.
struct RoughTexel {
    uint least;
    uint stride;
    vec2 offset;
};

RoughTexel rough_texel(RoughLevel level, vec3 direction) {
    uint face = cube_face(direction);
    vec3 c = cube_components(direction, face);
    uint stride = level.size + 2u * ROUGH_MAP_BORDER;
    vec2 position = (0.5 * float(level.size)) * (c.xy / c.z + 1.0) + float(ROUGH_MAP_BORDER) - 0.5;
    vec2 corner = clamp(floor(position), vec2(0.0), vec2(float(stride - 2u)));
    vec2 f = clamp(position - corner, 0.0, 1.0);
    return RoughTexel(level.first_texel + (face * stride + uint(corner.y)) * stride + uint(corner.x), stride, f);
}

/// Bilinear value of a level.
vec3 rough_level(RoughLevel level, vec3 direction) {
    RoughTexel texel = rough_texel(level, direction);
    return mix(mix(rough_texels[texel.least], rough_texels[texel.least + 1u], texel.offset.x),
               mix(rough_texels[texel.least + texel.stride], rough_texels[texel.least + texel.stride + 1u], texel.offset.x),
               texel.offset.y);
}

#include "kernels/glossy/rough_distance.glsl"

vec3 leave_rough_proxy(vec3 origin, vec3 direction, ProxyInfo proxy) {
    if (HAS_PROXY_PLANES == 0u || proxy.planes == 0u) return leave_box(origin, direction, proxy.lower, proxy.upper);
    float t = INFINITY;
    for (uint i = 0u; i < proxy.planes; ++i)
        t = leave_half_space(t, origin, direction, rough_proxy_planes[proxy.first_plane + i]);
    return origin + max(t, 0.0) * direction;
}

/// The direction from the capture point that stands for the mirrored one. Sphere maps are in eye space: rough lobes have
/// none, and take what is far.
vec3 rough_direction(Surface surface, RoughProbe probe, RoughLobe lobe, vec3 wi) {
    if (MAP_KIND == MAP_KIND_PROXY)
        return direction_to(leave_rough_proxy(surface.position, wi, probe.proxy), probe.capture_point, wi);
    if (MAP_KIND == MAP_KIND_DISTANCE) return direction_of_rough_hit(lobe, surface.position - probe.capture_point, wi);
    // Opposite vectors may cancel; nothing can be interpolated there.
    return MAP_KIND == MAP_KIND_POLYGON && drawn_reflection != vec3(0.0) ? drawn_reflection : wi;
}

RoughLobe rough_lobe(RoughMapInfo map, RoughProbe probe, float alpha) {
    float position = (sqrt(alpha) - map.least_roughness) * map.steps_per_unit;
    position = clamp(position, 0.0, float(map.levels - 1u));
    uint below = uint(position);
    uint above = min(below + 1u, map.levels - 1u);
    return RoughLobe(rough_levels[probe.first_level + below], rough_levels[probe.first_level + above],
                     position - float(below));
}

vec3 probe_radiance(Surface surface, RoughMapInfo map, uint index, vec3 wi) {
    RoughProbe probe = rough_probes[index];
    RoughLobe lobe = rough_lobe(map, probe, surface.alpha);
    vec3 direction = rough_direction(surface, probe, lobe, wi);
    vec3 radiance = rough_level(lobe.below, direction);
    if (lobe.share == 0.0) return radiance;
    return mix(radiance, rough_level(lobe.above, direction), lobe.share);
}

float lobe_passes_probe(Surface surface, uint index, vec3 wi) {
    return lobe_passes_at(surface.position - rough_probes[index].capture_point, wi, surface.alpha);
}

vec3 rough_radiance(Surface surface, vec3 wo) {
    RoughMapInfo map = rough_maps[triangle_infos[surface.triangle].instance];
    vec3 wi = reflect(-wo, surface.ns);
    if (MOST_ROUGH_PROBES == 1u) return probe_radiance(surface, map, map.first_probe, wi);
    float nearest = INFINITY;
    for (uint i = 0u; i < map.probes; ++i) nearest = min(nearest, lobe_passes_probe(surface, map.first_probe + i, wi));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint i = map.first_probe; i < map.first_probe + map.probes; ++i) {
        float weight = blend_weight(lobe_passes_probe(surface, i, wi), nearest, map.blend_width);
        if (weight == 0.0) continue;
        sum += weight * probe_radiance(surface, map, i, wi);
        weights += weight;
    }
    return sum / weights;
}

LobeAlbedo mix_albedo(LobeAlbedo a, LobeAlbedo b, float f) {
    return LobeAlbedo(mix(a.constant, b.constant, f), mix(a.schlick, b.schlick, f), mix(a.lost, b.lost, f));
}

LobeAlbedo lobe_albedo(Surface surface, float cos_o) {
    const float LAST = float(LOBE_ALBEDO_SIZE - 1u);
    vec2 position = LAST * clamp(sqrt(vec2(cos_o, surface.alpha)), 0.0, 1.0);
    vec2 corner = min(floor(position), LAST - 1.0);
    vec2 f = position - corner;
    uint entry = uint(corner.y) * LOBE_ALBEDO_SIZE + uint(corner.x);
    return mix_albedo(mix_albedo(lobe_albedos[entry], lobe_albedos[entry + 1u], f.x),
                      mix_albedo(lobe_albedos[entry + LOBE_ALBEDO_SIZE], lobe_albedos[entry + LOBE_ALBEDO_SIZE + 1u], f.x),
                      f.y);
}
