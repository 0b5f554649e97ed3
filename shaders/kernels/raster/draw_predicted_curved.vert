// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles that reflect like curved mirrors, with the maps they look up and the shape about them.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/listed_reflector.glsl"
#include "kernels/raster/polygon_shape.glsl"

void main() {
    set_listed_reflector();
    set_drawn_shape();
}
