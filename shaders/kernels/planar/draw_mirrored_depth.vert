// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles, and how far they are in front of the mirror that they are seen in.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_list.glsl"
#include "kernels/raster/drawn_projection.glsl"

layout(location = 0) out float in_front;

void main() {
    vec3 corner = listed_corner();
    in_front = dot(view.normal, corner) - view.offset;
    gl_Position = project(corner - view.camera.origin, listed_triangle());
}
