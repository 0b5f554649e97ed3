// SPDX-License-Identifier: Apache-2.0
// What a pixel of a reflector shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/raster/drawn_light.glsl"
#include "kernels/raster/map_lookup.glsl"
#include "lib/lobes/mirror.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    vec3 radiance = drawn_light(wo, surface);
    float state = DRAWN_PLAIN;
    if (is_mirror(surface)) {
        state = DRAWN_LOOKED_UP;
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) *
                    mapped_radiance(surface, mirror_direction(surface, wo));
    }
    drawn = vec4(radiance, state);
}
