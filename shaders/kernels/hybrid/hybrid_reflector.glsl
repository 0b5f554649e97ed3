// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels show hybrid_light.glsl.
#ifndef UTSURI_KERNELS_HYBRID_HYBRID_REFLECTOR
#define UTSURI_KERNELS_HYBRID_HYBRID_REFLECTOR

#include "kernels/hybrid/deferred_lobe.glsl"
#include "kernels/hybrid/hybrid_light.glsl"

layout(location = 1) out uvec4 drawn_deferred;

void draw_hybrid_reflector() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = DRAWN_PLAIN;
    vec3 radiance = drawn_light(wo, 0u, surface, state);
    if (is_mirror(surface)) radiance += hybrid_light(surface, wo, 0u, state);
    drawn = vec4(radiance, state);
    drawn_deferred = deferred;
}

#endif
