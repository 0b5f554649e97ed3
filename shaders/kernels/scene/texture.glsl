// SPDX-License-Identifier: Apache-2.0
// Texture lookups from a buffer of RGBA8 texels, filtered here so that every device gives the same picture.
#ifndef UTSURI_KERNELS_SCENE_TEXTURE
#define UTSURI_KERNELS_SCENE_TEXTURE

#include "kernels/scene/scene_bindings.glsl"

/// The remainder of a division that rounds down. Vulkan lets a quotient be off by 2.5 units in the last place, which may
/// take it past an integer: hence the bounds.
int remainder_of(int i, int size) {
    return clamp(i - size * int(floor(float(i) / float(size))), 0, size - 1);
}

/// Texel index for any integer, by a wrap mode.
int wrap_texel(int i, int size, uint mode) {
    if (mode == TEXTURE_CLAMP_TO_EDGE) return clamp(i, 0, size - 1);
    if (mode == TEXTURE_MIRRORED_REPEAT) {
        int j = remainder_of(i, 2 * size);
        return j < size ? j : 2 * size - 1 - j;
    }
    return remainder_of(i, size);
}

/// IEC 61966-2-1. The power 2.4 of u is u^2 (u^(1/4))^1.6, the latter by a polynomial with a relative error of 3e-7 over
/// the range that u can have here (Remez exchange): closer than pow() need be, and several times as fast on CPUs.
vec3 srgb_to_linear(vec3 c) {
    vec3 low = c / 12.92;
    vec3 u = (c + 0.055) / 1.055;
    vec3 v = sqrt(sqrt(u));
    vec3 p = ((((-0.0271936059 * v + 0.148197562) * v - 0.387461305) * v + 1.02485371) * v + 0.25584504) * v - 0.0142413614;
    return mix(u * u * p, low, lessThanEqual(c, vec3(0.04045)));
}

vec4 fetch_texel(TextureSlotInfo slot, ivec2 position, bool srgb) {
    int x = wrap_texel(position.x, int(slot.width), slot.sampling & TEXTURE_WRAP_MASK);
    int y = wrap_texel(position.y, int(slot.height), (slot.sampling >> TEXTURE_WRAP_BITS) & TEXTURE_WRAP_MASK);
    vec4 value = unpackUnorm4x8(texels[slot.first_texel + uint(y) * slot.width + uint(x)]);
    return srgb ? vec4(srgb_to_linear(value.rgb), value.a) : value;
}

/// Linear value at a texture coordinate, v downwards from the top row.
/// @param srgb how its colour is coded
vec4 sample_texture(TextureSlotInfo slot, vec2 texcoord, bool srgb) {
    // Beyond this range float32 cannot tell texels apart anyway; it keeps the integer conversion defined.
    vec2 position = clamp(texcoord * vec2(slot.width, slot.height), vec2(-16777216.0), vec2(16777216.0));
    if ((slot.sampling & TEXTURE_LINEAR) == 0u) {
        return fetch_texel(slot, ivec2(floor(position)), srgb);
    }
    vec2 corner = floor(position - 0.5);
    vec2 f = position - 0.5 - corner;
    ivec2 i = ivec2(corner);
    vec4 top = mix(fetch_texel(slot, i, srgb), fetch_texel(slot, i + ivec2(1, 0), srgb), f.x);
    vec4 bottom = mix(fetch_texel(slot, i + ivec2(0, 1), srgb), fetch_texel(slot, i + ivec2(1, 1), srgb), f.x);
    return mix(top, bottom, f.y);
}

#endif
