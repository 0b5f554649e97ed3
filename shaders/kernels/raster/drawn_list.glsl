// SPDX-License-Identifier: Apache-2.0
// The triangle of the scene that a vertex of a listed triangle belongs to.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_LIST
#define UTSURI_KERNELS_RASTER_DRAWN_LIST

#include "kernels/scene/scene_bindings.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_DRAW_LIST) readonly restrict buffer DrawnTriangles { uint draw_list[]; };

uint listed_triangle() {
    return draw_list[uint(gl_VertexIndex) / 3u];
}

vec3 listed_corner() {
    return bvh_vertex(listed_triangle(), uint(gl_VertexIndex) % 3u);
}

#endif
