// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a curved mirror: what its maps hold where that is predicted to be less pixels off its
// place than the tolerance, and what a ray meets elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/deferred_lobe.glsl"
#include "kernels/hybrid/hybrid_light.glsl"
#include "kernels/hybrid/look_up_by_place.glsl"
#include "kernels/planar/deferred_pixel.glsl"

void main() {
    if (!waits_for_this_view()) discard;
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = complete_after(view.reflections);
    vec3 radiance = drawn_light(wo, view.reflections, surface, state);
    if (is_mirror(surface)) radiance += hybrid_light(surface, wo, view.reflections, state);
    drawn = with_light(radiance, state);
    drawn_throughput = vec4(0.0);
    write_deferred();
}
