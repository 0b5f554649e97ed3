// SPDX-License-Identifier: Apache-2.0
// Points on a long thin triangle, dense where it is near: spread evenly over the angle at which its longest edge is seen
// (equiangular sampling, Kulla and Fajardo 2012), then evenly over the triangle's width there.
#ifndef UTSURI_LIB_EDGE_SAMPLING
#define UTSURI_LIB_EDGE_SAMPLING

#include "lib/numeric.glsl"
#include "lib/trigonometry.glsl"

/// The longest edge, from a to b, and the third corner c, as seen from a point. Lengths are in edges.
struct SeenEdge {
    vec3 edge;      ///< from a to b, times `scale`
    float scale;    ///< a power of two, per metre
    float start;    ///< where a is, from the place nearest to the point on the line through the edge
    float distance; ///< of that line
    float angle;    ///< at which the edge is seen, in ]0, pi[
    float foot;     ///< of c on the edge, in [0, 1]
    uint first;     ///< which corner a is
};

/// The distance counts as no less than half the triangle's width: nearer, its far side would be missed.
/// @param q0 corners as seen from the point, metres; not all on a line
SeenEdge seen_edge(vec3 q0, vec3 q1, vec3 q2) {
    vec3 squares = vec3(dot(q1 - q0, q1 - q0), dot(q2 - q1, q2 - q1), dot(q0 - q2, q0 - q2));
    SeenEdge seen;
    seen.first = squares.x >= max(squares.y, squares.z) ? 0u : (squares.y >= squares.z ? 1u : 2u);
    vec3 b = seen.first == 0u ? q1 : (seen.first == 1u ? q2 : q0);
    vec3 c = seen.first == 0u ? q2 : (seen.first == 1u ? q0 : q1);
    vec3 a = seen.first == 0u ? q0 : (seen.first == 1u ? q1 : q2);
    seen.edge = b - a;
    // No product of lengths overflows or vanishes.
    seen.scale = power_of_two_reciprocal(max_component(abs(seen.edge)));
    a *= seen.scale;
    seen.edge *= seen.scale;
    c *= seen.scale;
    float reciprocal = 1.0 / dot(seen.edge, seen.edge);
    vec3 beside = cross(a, seen.edge) * reciprocal;
    vec3 half_width = 0.5 * cross(c - a, seen.edge) * reciprocal;
    seen.start = dot(a, seen.edge) * reciprocal;
    seen.distance = sqrt(dot(beside, beside) + dot(half_width, half_width));
    seen.angle = angle_of(seen.distance, seen.start * (seen.start + 1.0) + seen.distance * seen.distance);
    seen.foot = clamp(dot(c - a, seen.edge) * reciprocal, 0.0, 1.0);
    return seen;
}

/// The width of the triangle at a place of its longest edge, over its greatest one.
float width_at(SeenEdge seen, float along) {
    return along < seen.foot ? along / seen.foot : (1.0 - along) / max(1.0 - seen.foot, UNIT_ROUNDOFF);
}

/// Weights of the second and third corner.
vec2 sample_edge(SeenEdge seen, vec2 u) {
    // By the law of sines in the triangle of the point and the part of the edge to cut off.
    float from_start = sin_of(u.x * seen.angle) * length(vec2(seen.start, seen.distance));
    float from_end = sin_of((1.0 - u.x) * seen.angle) * length(vec2(seen.start + 1.0, seen.distance));
    float along = from_start / (from_start + from_end);
    float of_c = u.y * width_at(seen, along);
    float of_b = max(along - of_c * seen.foot, 0.0);
    float of_a = max(1.0 - of_b - of_c, 0.0);
    return seen.first == 0u ? vec2(of_b, of_c) : (seen.first == 1u ? vec2(of_a, of_b) : vec2(of_c, of_a));
}

/// Density with which sample_edge() finds a point, over that of points spread evenly over the triangle.
/// @param to_point metres
float edge_density(SeenEdge seen, vec3 to_point) {
    float from_nearest = dot(to_point * seen.scale, seen.edge) / dot(seen.edge, seen.edge);
    float along = clamp(from_nearest - seen.start, 0.0, 1.0);
    float of_place = seen.distance / (seen.angle * (seen.distance * seen.distance + from_nearest * from_nearest));
    return of_place / (2.0 * width_at(seen, along));
}

#endif
