// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows where nothing is, which leaves nothing to rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_environment.glsl"

layout(location = 2) out uvec4 drawn_deferred;

void main() {
    draw_mirrored_environment();
    drawn_deferred = uvec4(DEFERRED_NONE);
}
