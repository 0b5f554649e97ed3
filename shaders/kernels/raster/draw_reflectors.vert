// SPDX-License-Identifier: Apache-2.0
// The corners of the reflectors' polygons, with what the per-vertex pass found there.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_reflector.glsl"

void main() {
    set_drawn_reflector();
}
