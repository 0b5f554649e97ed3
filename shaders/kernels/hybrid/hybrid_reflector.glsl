// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels show hybrid_light.glsl, which tells what the including kernel defines before.
#include "kernels/hybrid/hybrid_light.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    vec3 radiance = drawn_light(wo, surface);
    float found = DRAWN_PLAIN;
    if (is_specular(surface)) radiance += hybrid_light(surface, wo, 0u, found);
    drawn = vec4(radiance, found);
}
