// SPDX-License-Identifier: Apache-2.0
// The direction in which the capture point sees what a mirrored ray meets, told by how far away the light is that the rough
// lobe reflects there: a mean over the lobe, so that it bends as little as what is looked up.
#ifndef UTSURI_KERNELS_GLOSSY_ROUGH_DISTANCE
#define UTSURI_KERNELS_GLOSSY_ROUGH_DISTANCE

#include "kernels/glossy/rough_levels.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_ROUGH_INVERSE_DISTANCES) readonly restrict buffer RoughInverseDistances {
    float rough_inverse_distances[];
};

/// Places of the ray that texels are read for, beside the one at infinity: in a box of a room, rays that leave one of its
/// walls are then 0.0018 rad off in the mean as seen from the middle of that wall, 0.01 rad after two.
const uint ROUGH_HIT_STEPS = 4u;
/// A step takes the ray at most so many times as far back as the texel just read alone would: a wall is found if the ray
/// starts up to 7/8 of the way to it.
const float ROUGH_HIT_STRIDE = 8.0;
/// Found: where the texel says to this share how far it is. As an angle less than half a texel of the sharpest lobes.
const float ROUGH_HIT_PRECISION = 1.0 / 1024.0;

/// Bilinear, one over metres; 0: nothing is there.
float rough_level_inverse_distance(RoughLevel level, vec3 direction) {
    RoughTexel texel = rough_texel(level, direction);
    return mix(mix(rough_inverse_distances[texel.least], rough_inverse_distances[texel.least + 1u], texel.offset.x),
               mix(rough_inverse_distances[texel.least + texel.stride],
                   rough_inverse_distances[texel.least + texel.stride + 1u], texel.offset.x),
               texel.offset.y);
}

float rough_inverse_distance(RoughLobe lobe, vec3 direction) {
    float below = rough_level_inverse_distance(lobe.below, direction);
    return lobe.share == 0.0 ? below : mix(below, rough_level_inverse_distance(lobe.above, direction), lobe.share);
}

/// The ray is looked up where it is as far from the capture point as the texel there says. With s one over the length of the
/// ray, the capture point sees that place along q = s origin + direction, and what is looked for is a zero of
/// |q| inverse_distance(q) - s. That is positive beyond what is kept, and affine in s where that is a plane, so that one
/// secant finds it. Between places on both sides: false position, Illinois variant (Dowell and Jarratt 1971).
/// @param origin of the ray, from the capture point
/// @param direction unit
vec3 direction_of_rough_hit(RoughLobe lobe, vec3 origin, vec3 direction) {
    float beyond = 0.0;
    float beyond_by = rough_inverse_distance(lobe, direction);
    float before = INFINITY;
    float before_by = 0.0;
    bool was_beyond = false;
    float s = beyond_by;
    for (uint i = 0u; i < ROUGH_HIT_STEPS; ++i) {
        vec3 place = s * origin + direction;
        if (place == vec3(0.0)) break;  // at the capture point
        float by = length(place) * rough_inverse_distance(lobe, place) - s;
        if (abs(by) <= ROUGH_HIT_PRECISION * s) break;
        float stride = ROUGH_HIT_STRIDE;
        if (by > 0.0) {
            if (by < beyond_by) stride = min(stride, (s - beyond) / (beyond_by - by));
            if (was_beyond) before_by *= 0.5;
            beyond = s;
            beyond_by = by;
        } else {
            if (!was_beyond && !isinf(before)) beyond_by *= 0.5;
            before = s;
            before_by = by;
        }
        was_beyond = by > 0.0;
        if (!isinf(before)) stride = (before - beyond) / (beyond_by - before_by);
        s = beyond + stride * beyond_by;
    }
    vec3 place = s * origin + direction;
    return place == vec3(0.0) ? direction : place;
}

#endif
