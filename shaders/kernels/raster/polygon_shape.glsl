// SPDX-License-Identifier: Apache-2.0
// Sets what the vertex stage tells of the shape about a triangle of the scene.
#ifndef UTSURI_KERNELS_RASTER_POLYGON_SHAPE
#define UTSURI_KERNELS_RASTER_POLYGON_SHAPE

#include "kernels/raster/drawn_shape.glsl"
#include "kernels/raster/drawn_surface.glsl"
#include "kernels/scene/scene_bindings.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_SELF_HORIZONS) readonly restrict buffer SelfHorizons { float self_horizons[]; };

/// Turn of the normal along an edge over its length.
float edge_curvature(vec3 from, vec3 to, vec3 from_normal, vec3 to_normal) {
    vec3 edge = to - from;
    float length2 = dot(edge, edge);
    return length2 > 0.0 ? dot(to_normal - from_normal, edge) / length2 : 0.0;
}

/// Along that edge where they turn least, radians a metre; > 0 where the front is convex.
float least_curvature(uint triangle) {
    BvhTriangle corners = bvh_triangle(triangle);
    uvec3 vertices = triangle_infos[triangle].vertices;
    vec3 n0 = normals[vertices.x];
    vec3 n1 = normals[vertices.y];
    vec3 n2 = normals[vertices.z];
    return min(edge_curvature(corners.v0, corners.v1, n0, n1),
               min(edge_curvature(corners.v1, corners.v2, n1, n2), edge_curvature(corners.v2, corners.v0, n2, n0)));
}

void set_drawn_shape() {
    drawn_curvature = least_curvature(drawn_ids.x);
    drawn_horizon = self_horizons[drawn_ids.x];
}

#endif
