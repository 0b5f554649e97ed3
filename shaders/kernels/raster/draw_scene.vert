// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_list.glsl"
#include "kernels/raster/drawn_projection.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "lib/map_constants.glsl"

void main() {
    uint corner = uint(gl_VertexIndex) % 3u;
    set_drawn_triangle(listed_triangle(), vec2(corner == 1u, corner == 2u));
    drawn_from_eye = listed_corner() - view.camera.origin;
    // Not normalised, as for mirrors: see reflect_vertices.comp.
    if (HAS_GLOSSY && MAP_KIND == MAP_KIND_POLYGON) {
        drawn_reflection = reflect(drawn_from_eye, normalize_any_scale(drawn_normal));
    }
    gl_Position = project(drawn_from_eye, listed_triangle());
}
