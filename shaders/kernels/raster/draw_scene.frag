// SPDX-License-Identifier: Apache-2.0
// What a pixel of a surface that is no mirror shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/raster/mapped_lobe.glsl"

void main() {
    Surface surface;
    float state = DRAWN_PLAIN;
    vec3 radiance = drawn_light(-normalize_any_scale(drawn_from_eye), 0u, surface, state);
    drawn = vec4(radiance, state);
}
