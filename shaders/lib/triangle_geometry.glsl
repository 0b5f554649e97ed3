// SPDX-License-Identifier: Apache-2.0
// Points and normals of triangles.
#ifndef UTSURI_LIB_TRIANGLE_GEOMETRY
#define UTSURI_LIB_TRIANGLE_GEOMETRY

#include "interop/bvh.h"
#include "lib/numeric.glsl"

/// Barycentric coordinates b1 and b2 are the weights of v1 and v2.
vec3 triangle_point(BvhTriangle vertices, float b1, float b2) {
    return (1.0 - b1 - b2) * vertices.v0 + b1 * vertices.v1 + b2 * vertices.v2;
}

/// Bound on the rounding error of triangle_point(): seven roundings of each term.
vec3 triangle_point_error(BvhTriangle vertices, float b1, float b2) {
    vec3 terms = abs((1.0 - b1 - b2) * vertices.v0) + abs(b1 * vertices.v1) + abs(b2 * vertices.v2);
    return rounding_bound(7.0) * terms;
}

/// Twice the vector area; the direction is that of the front.
vec3 triangle_cross(BvhTriangle vertices) {
    return cross(vertices.v1 - vertices.v0, vertices.v2 - vertices.v0);
}

/// Unit, of the front; zero where there is no area.
vec3 triangle_normal(BvhTriangle vertices) {
    return normalize_any_scale(triangle_cross(vertices));
}

#endif
