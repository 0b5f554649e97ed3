// SPDX-License-Identifier: Apache-2.0
// The texels of reflection maps, which are captured when they are first looked up.
#ifndef UTSURI_KERNELS_MAPS_MAP_TEXELS
#define UTSURI_KERNELS_MAPS_MAP_TEXELS

#include "kernels/maps/probes.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_MAP_TEXELS) readonly restrict buffer MapTexels { vec3 map_texels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_STATES) restrict buffer MapStates {
    uint wanted_maps;
    uint map_states[];
};

/// Whether a map is there. One that is not is asked for, and the picture is drawn anew when it is.
bool is_captured(uint map) {
    if (map_states[map] == MAP_CAPTURED) return true;
    if (atomicMax(map_states[map], MAP_WANTED) == MAP_EMPTY) atomicAdd(wanted_maps, 1u);
    return false;
}

/// Bilinear value of a probe's map at picture coordinates in [-1, 1]^2; the border makes all four texels its own.
/// @param face 0 of a sphere map, which has no faces
vec3 sample_map(uint probe, uint face, vec2 p) {
    if (!is_captured(probe * max(FACE_COUNT, 1u) + face)) return vec3(0.0);
    float size = float(probes[probe].map_size);
    uint stride = probes[probe].map_size + 2u * MAP_BORDER;
    vec2 position = vec2(0.5, -0.5) * size * p + (0.5 * size + float(MAP_BORDER)) - 0.5;
    vec2 corner = clamp(floor(position), vec2(0.0), vec2(float(stride - 2u)));
    vec2 f = clamp(position - corner, 0.0, 1.0);
    uint texel = probes[probe].first_texel + (face * stride + uint(corner.y)) * stride + uint(corner.x);
    vec3 top = mix(map_texels[texel], map_texels[texel + 1u], f.x);
    vec3 bottom = mix(map_texels[texel + stride], map_texels[texel + stride + 1u], f.x);
    return mix(top, bottom, f.y);
}

#endif
