// SPDX-License-Identifier: Apache-2.0
// Irradiance from a triangle that shines evenly, in closed form (Lambert 1760). Straight code without loops or arrays: on a CPU
// every lane of a subgroup goes through all of it anyway.
#ifndef UTSURI_LIB_TRIANGLE_IRRADIANCE
#define UTSURI_LIB_TRIANGLE_IRRADIANCE

#include "lib/numeric.glsl"
#include "lib/trigonometry.glsl"

/// Where the way from a to b meets a horizon, of which they lie on different sides.
vec3 horizon_point(vec3 a, vec3 b, float height_a, float height_b) {
    return mix(a, b, height_a / (height_a - height_b));
}

/// Twice the part of Lambert's contour integral along the great circle from a to b, of any length.
float contour_part(vec3 a, vec3 b, vec3 n) {
    vec3 across = cross(a, b);
    float sine = length(across);
    return sine > 0.0 ? angle_of(sine, dot(a, b)) * dot(across, n) / sine : 0.0;
}

/// Where the contour leaves the part above a horizon, and where it comes back.
struct HorizonCut {
    vec3 exit;
    vec3 entry;
};

/// contour_part() of what of the edge is above the horizon of n.
float edge_above(vec3 a, vec3 b, vec3 n, inout HorizonCut cut) {
    float height_a = dot(a, n);
    float height_b = dot(b, n);
    bool a_above = height_a > 0.0;
    bool b_above = height_b > 0.0;
    if (!a_above && !b_above) return 0.0;
    if (a_above && b_above) return contour_part(a, b, n);
    vec3 between = horizon_point(a, b, height_a, height_b);
    if (a_above) {
        cut.exit = between;
    } else {
        cut.entry = between;
    }
    return a_above ? contour_part(a, between, n) : contour_part(between, b, n);
}

/// A triangle cut by a plane through the origin; without the cut, two corners are one.
struct CutTriangle {
    vec3 p0;
    vec3 p1;
    vec3 p2;
    vec3 p3;
};

/// What of a triangle is above the horizon of n; without area where nothing is.
CutTriangle above_horizon(vec3 a, vec3 b, vec3 c, vec3 n) {
    vec3 heights = vec3(dot(a, n), dot(b, n), dot(c, n));
    bvec3 above = greaterThan(heights, vec3(0.0));
    uint count = uint(above.x) + uint(above.y) + uint(above.z);
    // Turned so that the corner that is alone on its side comes first.
    bvec3 is_alone = equal(above, bvec3(count == 1u));
    if (!is_alone.x && is_alone.y) {
        vec3 first = a;
        a = b;
        b = c;
        c = first;
        heights = heights.yzx;
    } else if (!is_alone.x && is_alone.z) {
        vec3 first = a;
        a = c;
        c = b;
        b = first;
        heights = heights.zxy;
    }
    if (count == 3u) return CutTriangle(a, b, c, c);
    if (count == 0u) return CutTriangle(a, a, a, a);
    vec3 ab = horizon_point(a, b, heights.x, heights.y);
    vec3 ac = horizon_point(a, c, heights.x, heights.z);
    return count == 1u ? CutTriangle(a, ab, ac, ac) : CutTriangle(ab, b, c, ac);
}

/// Irradiance at the origin from a triangle of radiance 1, of which only what is above both horizons shines.
/// @param q0, q1, q2 its corners, in lengths of any unit
/// @param ng, ns unit normals
float triangle_irradiance(vec3 q0, vec3 q1, vec3 q2, vec3 ng, vec3 ns) {
    // No product of lengths overflows or vanishes.
    float scale = power_of_two_reciprocal(max_component(abs(q0) + abs(q1) + abs(q2)));
    CutTriangle seen = above_horizon(q0 * scale, q1 * scale, q2 * scale, ng);
    HorizonCut cut = HorizonCut(vec3(0.0), vec3(0.0));
    float sum = edge_above(seen.p0, seen.p1, ns, cut) + edge_above(seen.p1, seen.p2, ns, cut) +
                edge_above(seen.p2, seen.p3, ns, cut) + edge_above(seen.p3, seen.p0, ns, cut);
    return 0.5 * abs(sum + contour_part(cut.exit, cut.entry, ns));
}

#endif
