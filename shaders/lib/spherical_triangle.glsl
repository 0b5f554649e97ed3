// SPDX-License-Identifier: Apache-2.0
// A triangle as it is seen from a point: its solid angle, and directions spread evenly over it.
#ifndef UTSURI_LIB_SPHERICAL_TRIANGLE
#define UTSURI_LIB_SPHERICAL_TRIANGLE

#include "lib/numeric.glsl"
#include "lib/trigonometry.glsl"

struct SphericalTriangle {
    vec3 a;  ///< unit directions to the corners
    vec3 b;
    vec3 c;
    float volume;       ///< of the parallelepiped that they span
    float solid_angle;  ///< sr
};

/// Van Oosterom and Strackee 1983. Of the corners, the two that are most nearly opposite become b and c: sampled so, what
/// float32 rounds stays below a thousandth of the triangle for volumes of at least 2^-12.
/// @param q0 corners as seen from the point, metres, none of them zero
SphericalTriangle spherical_triangle(vec3 q0, vec3 q1, vec3 q2) {
    vec3 a = normalize_any_scale(q0);
    vec3 b = normalize_any_scale(q1);
    vec3 c = normalize_any_scale(q2);
    vec3 cosines = vec3(dot(b, c), dot(c, a), dot(a, b));
    float volume = abs(dot(a, cross(b, c)));
    float solid_angle = 2.0 * angle_of(volume, 1.0 + cosines.x + cosines.y + cosines.z);
    if (cosines.x <= min(cosines.y, cosines.z)) return SphericalTriangle(a, b, c, volume, solid_angle);
    if (cosines.y <= cosines.z) return SphericalTriangle(b, c, a, volume, solid_angle);
    return SphericalTriangle(c, a, b, volume, solid_angle);
}

/// A unit direction within it; uniform over solid angle for uniform u (after Arvo 1995). The arc from b to a point of the
/// edge from a to c cuts off the share u.x; the other number chooses along that arc.
vec3 sample_spherical_triangle(SphericalTriangle triangle, vec2 u) {
    // The point is p = x a + y c, where the tangent of half the angle to cut off is what Van Oosterom and Strackee have for
    // (a, b, p): then y / (1 + x) = n / m.
    vec2 half_angle = cos_sin_of_turn(u.x * triangle.solid_angle / (4.0 * PI));
    float ac = dot(triangle.a, triangle.c);
    float n = half_angle.y * (1.0 + dot(triangle.a, triangle.b));
    float m = triangle.volume * half_angle.x - half_angle.y * (ac + dot(triangle.b, triangle.c));
    vec3 p = normalize_any_scale((m - n) * (m + n) * triangle.a + 2.0 * n * (m + n * ac) * triangle.c);
    vec3 from_b = p - triangle.b;
    float versine = 0.5 * dot(from_b, from_b);  // 1 - dot(b, p), which would be lost to rounding on a short arc
    float height = min(u.y * versine, 2.0);
    vec3 across = normalize_any_scale(from_b + versine * triangle.b);
    return (1.0 - height) * triangle.b + sqrt(height * (2.0 - height)) * across;
}

#endif
