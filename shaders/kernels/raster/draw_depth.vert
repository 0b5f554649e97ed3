// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles and nothing else: drawn first, so that only what is visible is shaded.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_list.glsl"
#include "kernels/raster/drawn_projection.glsl"

void main() {
    gl_Position = project(listed_corner() - view.camera.origin, listed_triangle());
}
