// SPDX-License-Identifier: Apache-2.0
// The corners of the reflectors' polygons and nothing else: drawn first, so that only what is visible is shaded.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/raster.h"
#include "interop/specialization.h"
#include "lib/numeric.glsl"
#include "kernels/raster/drawn_vertex.glsl"
#include "kernels/reflectors/reflector_bindings.glsl"

layout(scalar, binding = BINDING_DRAWN_POLYGONS) readonly restrict buffer DrawnPolygons { uint drawn_polygons[]; };

void main() {
    ReflectorTriangle polygon = reflector_triangles[drawn_polygons[uint(gl_VertexIndex) / 3u]];
    gl_Position = project(reflector_vertices[polygon.vertices[uint(gl_VertexIndex) % 3u]].position - push.camera.origin);
}
