// SPDX-License-Identifier: Apache-2.0
// Whole polygons of reflectors, with how curved they are.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "interop/reflection.h"
#include "lib/surface.glsl"
#include "kernels/drawn_triangle.glsl"
#include "kernels/drawn_curvature.glsl"
#include "kernels/drawn_vertex.glsl"
#include "kernels/reflector_bindings.glsl"
#include "kernels/drawn_reflector.glsl"

/// Turn of the normal along an edge over its length.
float edge_curvature(vec3 from, vec3 to, vec3 from_normal, vec3 to_normal) {
    vec3 edge = to - from;
    float length2 = dot(edge, edge);
    return length2 > 0.0 ? dot(to_normal - from_normal, edge) / length2 : 0.0;
}

void main() {
    set_drawn_reflector();
    BvhTriangle corners = bvh_triangles[drawn_ids.x];
    uvec3 vertices = triangle_infos[drawn_ids.x].vertices;
    vec3 n0 = normals[vertices.x];
    vec3 n1 = normals[vertices.y];
    vec3 n2 = normals[vertices.z];
    drawn_curvature = min(edge_curvature(corners.v0, corners.v1, n0, n1),
                          min(edge_curvature(corners.v1, corners.v2, n1, n2), edge_curvature(corners.v2, corners.v0, n2, n0)));
}
