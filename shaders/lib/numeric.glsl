// SPDX-License-Identifier: Apache-2.0
// Floating point tools that know no absolute size: scaling all lengths by a power of two scales results exactly.
#ifndef UTSURI_LIB_NUMERIC
#define UTSURI_LIB_NUMERIC

const float PI = 3.14159265358979324;
const float INFINITY = 1.0 / 0.0;
const float ONE_BELOW_1 = 0.99999994;  // the largest float32 below 1
/// Half the distance from 1 to the next float: the largest relative error of one rounding.
const float UNIT_ROUNDOFF = 5.9604644775390625e-8;  // 2^-24

/// Bound on the relative error of n successive roundings (Higham 2002, lemma 3.1).
float rounding_bound(float n) {
    return n * UNIT_ROUNDOFF / (1.0 - n * UNIT_ROUNDOFF);
}

float max_component(vec3 v) {
    return max(v.x, max(v.y, v.z));
}

/// A power of two s with 1 <= s * x < 4, for x > 0 and normal; below 2 but for x >= 2^127, whose reciprocal is not normal.
float power_of_two_reciprocal(float x) {
    return uintBitsToFloat(max(0x7f000000u - (floatBitsToUint(x) & 0x7f800000u), 0x00800000u));
}

/// v / |v|, scaled by a power of two first, so that squares neither overflow nor vanish. Zero stays zero.
vec3 normalize_any_scale(vec3 v) {
    float largest = max_component(abs(v));
    if (!(largest > 0.0)) return vec3(0.0);
    vec3 scaled = v * power_of_two_reciprocal(largest);
    return scaled * inversesqrt(dot(scaled, scaled));
}

bool is_finite(vec3 v) {
    return !any(isnan(v)) && !any(isinf(v));
}

/// The components of v in cyclic order from the one after `axis` on, so that component `axis` comes last.
vec3 axis_last(vec3 v, uint axis) {
    return axis == 0u ? v.yzx : (axis == 1u ? v.zxy : v);
}

/// The axis of the largest magnitude; the first of equals.
uint major_axis(vec3 v) {
    vec3 a = abs(v);
    return a.x >= a.y ? (a.x >= a.z ? 0u : 2u) : (a.y >= a.z ? 1u : 2u);
}

/// The float next to x, upwards where direction > 0, downwards where direction < 0.
float next_float_towards(float x, float direction) {
    if (direction == 0.0 || x == 0.0) return x;
    bool away_from_zero = (direction > 0.0) == (x > 0.0);
    return uintBitsToFloat(away_from_zero ? floatBitsToUint(x) + 1u : floatBitsToUint(x) - 1u);
}

/// Where a ray along w may start so that it cannot hit the surface it leaves: the point moved along the geometric
/// normal by its error bound, rounded outwards (Pharr, Jakob and Humphreys 2023, section 6.8.6).
vec3 offset_origin(vec3 point, vec3 error_bound, vec3 normal, vec3 w) {
    vec3 offset = dot(abs(normal), error_bound) * normal;
    if (dot(w, normal) < 0.0) offset = -offset;
    vec3 moved = point + offset;
    return vec3(next_float_towards(moved.x, offset.x), next_float_towards(moved.y, offset.y),
                next_float_towards(moved.z, offset.z));
}

#endif
