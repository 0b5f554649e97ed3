// SPDX-License-Identifier: Apache-2.0
// What a pixel of a surface that is no mirror shows, its glossy lobe left to rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/deferred_lobe.glsl"

layout(location = 1) out uvec4 drawn_deferred;

void main() {
    Surface surface;
    float state = DRAWN_PLAIN;
    vec3 radiance = drawn_light(-normalize_any_scale(drawn_from_eye), 0u, surface, state);
    drawn = vec4(radiance, state);
    drawn_deferred = deferred;
}
