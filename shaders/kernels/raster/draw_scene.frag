// SPDX-License-Identifier: Apache-2.0
// What a pixel of a surface that is no mirror shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/raster/drawn_light.glsl"

void main() {
    Surface surface;
    drawn = vec4(drawn_light(-normalize_any_scale(drawn_from_eye), surface), DRAWN_PLAIN);
}
