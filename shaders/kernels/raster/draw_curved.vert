// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles that reflect like curved mirrors, with the maps they look up.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/listed_reflector.glsl"

void main() {
    set_listed_reflector();
}
