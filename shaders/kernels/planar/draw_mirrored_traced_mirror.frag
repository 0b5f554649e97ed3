// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a plane mirror whose own view is not drawn: the mirror's own light, and what a ray meets.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/traced_lobe.glsl"
#include "kernels/planar/mirrored_pixel.glsl"

layout(location = 1) out vec4 drawn_throughput;

void main() {
    if (!waits_for_this_view()) discard;
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = complete_after(view.reflections);
    vec3 radiance = drawn_light(wo, view.reflections, surface, state);
    if (is_mirror(surface)) {
        TracedReflection traced = trace_reflection(wo, view.reflections);
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) * traced.radiance;
        state = traced_at_plane_mirror(view.reflections, traced.rays, traced.cut);
    }
    drawn = with_light(radiance, state);
    drawn_throughput = vec4(0.0);
}
