// SPDX-License-Identifier: Apache-2.0
// What the lobes of a surface reflect of a uniform environment, from a table.
#ifndef UTSURI_KERNELS_LIGHT_LOBE_ALBEDO
#define UTSURI_KERNELS_LIGHT_LOBE_ALBEDO

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/lobe_albedo.h"
#include "lib/reflectance.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LOBE_ALBEDO) readonly restrict buffer LobeAlbedos { LobeAlbedo lobe_albedos[]; };

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

/// Share of the light of a uniform environment that the glossy lobe reflects to a viewer at this cosine.
vec3 glossy_share(Surface surface, float cos_o) {
    LobeAlbedo albedo = lobe_albedo(surface, cos_o);
    return specular_reflectance(surface, 1.0) * albedo.constant + specular_reflectance(surface, 0.0) * albedo.schlick;
}

/// LobeAlbedo::lost alone: it is the same whatever alpha is, so that one row of the table tells.
float lost_under_lobe(float cos_o) {
    const float LAST = float(LOBE_ALBEDO_SIZE - 1u);
    float position = LAST * clamp(sqrt(cos_o), 0.0, 1.0);
    float corner = min(floor(position), LAST - 1.0);
    return mix(lobe_albedos[uint(corner)].lost, lobe_albedos[uint(corner) + 1u].lost, position - corner);
}

/// Share of the light that arrives which leaves diffusely from under a glossy lobe.
/// @param lost as LobeAlbedo has it
vec3 diffuse_under_lobe(Surface surface, float lost) {
    float kept = 1.0 - mix(max_component(surface.f0), surface.f90, lost);
    return surface.base_colour * ((1.0 - surface.metallic) * kept);
}

#endif
