// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows where nothing is.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_environment.glsl"

void main() {
    draw_mirrored_environment();
}
