// SPDX-License-Identifier: Apache-2.0
// What kernels that look reflections up in captured maps share.
#include "kernels/probe_bindings.glsl"

layout(constant_id = SPEC_MAP_SIZE) const uint MAP_SIZE = 256u;

layout(scalar, binding = BINDING_MAP_TEXELS) readonly restrict buffer MapTexels { vec3 map_texels[]; };

/// Bilinear value of a map at picture coordinates in [-1, 1]^2; the border makes all four texels its own.
vec3 sample_map(uint first_texel, vec2 p) {
    uint stride = MAP_SIZE + 2u * MAP_BORDER;
    vec2 position = vec2(0.5, -0.5) * float(MAP_SIZE) * p + (0.5 * float(MAP_SIZE) + float(MAP_BORDER)) - 0.5;
    vec2 corner = clamp(floor(position), vec2(0.0), vec2(float(stride - 2u)));
    vec2 f = clamp(position - corner, 0.0, 1.0);
    uint texel = first_texel + uint(corner.y) * stride + uint(corner.x);
    vec3 top = mix(map_texels[texel], map_texels[texel + 1u], f.x);
    vec3 bottom = mix(map_texels[texel + stride], map_texels[texel + stride + 1u], f.x);
    return mix(top, bottom, f.y);
}
