// SPDX-License-Identifier: Apache-2.0
// What a pixel of a reflector shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/raster/map_lookup.glsl"
#include "kernels/raster/mapped_lobe.glsl"
#include "lib/lobes/mirror.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = DRAWN_PLAIN;
    vec3 radiance = drawn_light(wo, 0u, surface, state);
    if (is_mirror(surface)) {
        state = DRAWN_LOOKED_UP;
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) *
                    mapped_radiance(surface, mirror_direction(surface, wo));
    }
    drawn = vec4(radiance, state);
}
