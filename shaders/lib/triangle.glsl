// SPDX-License-Identifier: Apache-2.0
// Watertight ray-triangle intersection (Woop, Benthin and Wald 2013): the triangle is moved into a space where the ray
// is the z axis, so that a ray that passes an edge is decided by the same numbers for both triangles that share it.
#ifndef UTSURI_LIB_TRIANGLE
#define UTSURI_LIB_TRIANGLE

#include "lib/numeric.glsl"

struct ShearedRay {
    vec3 origin;
    uint axis;     ///< along which the direction is longest
    vec3 shear;    ///< xy: direction over its longest component; z: one over that component
};

ShearedRay shear_ray(vec3 origin, vec3 direction) {
    uint axis = major_axis(direction);
    vec3 d = axis_last(direction, axis);
    float reciprocal = 1.0 / d.z;
    return ShearedRay(origin, axis, vec3(d.xy * reciprocal, reciprocal));
}

struct TriangleHit {
    float t;
    float b1;
    float b2;
    bool hit;     ///< the line hits; t is yet to be held against the ray's interval
};

/// Both sides count; a triangle of which two vertices coincide is never hit, and one that is seen edge-on only where
/// rounding makes a sliver of it, at a distance among those of its vertices. The edge functions must not be contracted
/// into fused multiply-adds: with them, shared edges leak.
TriangleHit intersect_triangle(ShearedRay ray, vec3 v0, vec3 v1, vec3 v2) {
    vec3 a = axis_last(v0 - ray.origin, ray.axis);
    vec3 b = axis_last(v1 - ray.origin, ray.axis);
    vec3 c = axis_last(v2 - ray.origin, ray.axis);
    precise vec2 pa = a.xy - ray.shear.xy * a.z;
    precise vec2 pb = b.xy - ray.shear.xy * b.z;
    precise vec2 pc = c.xy - ray.shear.xy * c.z;
    precise float u = pc.x * pb.y - pc.y * pb.x;
    precise float v = pa.x * pc.y - pa.y * pc.x;
    precise float w = pb.x * pa.y - pb.y * pa.x;
    bool outside = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
    precise float determinant = u + v + w;
    precise float depth = u * a.z + v * b.z + w * c.z;
    float reciprocal = 1.0 / determinant;
    precise float t = depth * ray.shear.z * reciprocal;
    return TriangleHit(t, v * reciprocal, w * reciprocal, !outside && determinant != 0.0);
}

#endif
