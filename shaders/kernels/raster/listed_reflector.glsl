// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles of reflectors.
#ifndef UTSURI_KERNELS_RASTER_LISTED_REFLECTOR
#define UTSURI_KERNELS_RASTER_LISTED_REFLECTOR

#include "kernels/raster/drawn_list.glsl"
#include "kernels/raster/drawn_projection.glsl"
#include "kernels/raster/drawn_triangle.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LISTED_REFLECTORS) readonly restrict buffer ListedReflectors {
    uint listed_reflectors[];
};

void set_listed_reflector() {
    uint corner = uint(gl_VertexIndex) % 3u;
    set_drawn_triangle(listed_triangle(), vec2(corner == 1u, corner == 2u));
    drawn_ids.w = listed_reflectors[uint(gl_VertexIndex) / 3u];
    drawn_from_eye = listed_corner() - view.camera.origin;
    gl_Position = project(drawn_from_eye, listed_triangle());
}

#endif
