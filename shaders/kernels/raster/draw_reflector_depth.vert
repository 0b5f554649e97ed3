// SPDX-License-Identifier: Apache-2.0
// The corners of the reflectors' polygons and nothing else: drawn first, so that only what is visible is shaded.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_polygons.glsl"
#include "kernels/raster/drawn_projection.glsl"

void main() {
    ReflectorTriangle polygon = drawn_polygon();
    vec3 corner = reflector_vertices[polygon.vertices[uint(gl_VertexIndex) % 3u]].position;
    gl_Position = project(corner - view.camera.origin, polygon.triangle);
}
