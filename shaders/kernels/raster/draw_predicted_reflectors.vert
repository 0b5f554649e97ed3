// SPDX-License-Identifier: Apache-2.0
// Whole polygons of reflectors, with the shape about them.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_reflector.glsl"
#include "kernels/raster/polygon_shape.glsl"

void main() {
    set_drawn_reflector();
    set_drawn_shape();
}
