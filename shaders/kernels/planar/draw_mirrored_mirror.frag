// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a plane mirror: the mirror's own light; for what it reflects the pixel waits.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_pixel.glsl"
#include "kernels/raster/drawn_light.glsl"

layout(location = 1) out vec4 drawn_throughput;

void main() {
    if (!waits_for_this_view()) discard;
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    vec3 radiance = drawn_light(wo, surface);
    bool mirrors = is_mirror(surface);
    float state = complete_after(view.reflections);
    if (mirrors) state = view.next == VIEW_TRUNCATED ? truncated_at(view.reflections + 1u) : waiting_for(view.next);
    drawn = with_light(radiance, state);
    vec3 reflectance = mirrors ? specular_reflectance(surface, abs(dot(surface.ns, wo))) : vec3(0.0);
    drawn_throughput = vec4(with_reflectance(reflectance), 0.0);
}
