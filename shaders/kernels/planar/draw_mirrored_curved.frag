// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a curved mirror: what its maps hold.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_throughput.glsl"
#include "kernels/raster/map_lookup.glsl"
#include "kernels/raster/mapped_lobe.glsl"
#include "lib/lobes/mirror.glsl"

void main() {
    if (!waits_for_this_view()) discard;
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = complete_after(view.reflections);
    vec3 radiance = drawn_light(wo, view.reflections, surface, state);
    if (is_mirror(surface)) {
        state = found_in_map(view.reflections);
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) *
                    mapped_radiance(surface, mirror_direction(surface, wo));
    }
    drawn = with_light(radiance, state);
    drawn_throughput = vec4(0.0);
}
