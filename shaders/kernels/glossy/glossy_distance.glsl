// SPDX-License-Identifier: Apache-2.0
// The direction in which the capture point sees what a mirrored ray meets, told by how far away the light is that the rough
// lobe reflects there: a mean over the lobe, so that it bends as little as what is looked up.
#ifndef UTSURI_KERNELS_GLOSSY_GLOSSY_DISTANCE
#define UTSURI_KERNELS_GLOSSY_GLOSSY_DISTANCE

#include "kernels/glossy/glossy_levels.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_INVERSE_DISTANCES) readonly restrict buffer GlossyInverseDistances {
    float glossy_inverse_distances[];
};

/// Places of the ray that texels are read for, beside the one at infinity: in a box of a room, rays that leave one of its
/// walls are then 0.0018 rad off in the mean as seen from the middle of that wall, 0.01 rad after two.
const uint GLOSSY_HIT_STEPS = 4u;
/// A step takes the ray at most so many times as far back as the texel just read alone would: a wall is found if the ray
/// starts up to 7/8 of the way to it.
const float GLOSSY_HIT_STRIDE = 8.0;
/// Found: where the texel says to this share how far it is. As an angle less than half a texel of the sharpest lobes.
const float GLOSSY_HIT_PRECISION = 1.0 / 1024.0;

/// Bilinear, one over metres; 0: nothing is there.
float glossy_level_inverse_distance(GlossyLevel level, vec3 direction) {
    GlossyTexel texel = glossy_texel(level, direction);
    return mix(mix(glossy_inverse_distances[texel.least], glossy_inverse_distances[texel.least + 1u], texel.offset.x),
               mix(glossy_inverse_distances[texel.least + texel.stride],
                   glossy_inverse_distances[texel.least + texel.stride + 1u], texel.offset.x),
               texel.offset.y);
}

float glossy_inverse_distance(GlossyLobe lobe, vec3 direction) {
    float below = glossy_level_inverse_distance(lobe.below, direction);
    return lobe.share == 0.0 ? below : mix(below, glossy_level_inverse_distance(lobe.above, direction), lobe.share);
}

/// The ray is looked up where it is as far from the capture point as the texel there says. With s one over the length of the
/// ray, the capture point sees that place along q = s origin + direction, and what is looked for is a zero of
/// |q| inverse_distance(q) - s. That is positive beyond what is kept, and affine in s where that is a plane, so that one
/// secant finds it. Between places on both sides: false position, Illinois variant (Dowell and Jarratt 1971).
/// @param origin of the ray, from the capture point
/// @param direction unit
vec3 direction_of_glossy_hit(GlossyLobe lobe, vec3 origin, vec3 direction) {
    float beyond = 0.0;
    float error_beyond = glossy_inverse_distance(lobe, direction);
    float before = INFINITY;
    float error_before = 0.0;
    bool was_beyond = false;
    float s = error_beyond;
    for (uint i = 0u; i < GLOSSY_HIT_STEPS; ++i) {
        vec3 place = s * origin + direction;
        if (place == vec3(0.0)) break;  // at the capture point
        float by = length(place) * glossy_inverse_distance(lobe, place) - s;
        if (abs(by) <= GLOSSY_HIT_PRECISION * s) break;
        float stride = GLOSSY_HIT_STRIDE;
        if (by > 0.0) {
            if (by < error_beyond) stride = min(stride, (s - beyond) / (error_beyond - by));
            if (was_beyond) error_before *= 0.5;
            beyond = s;
            error_beyond = by;
        } else {
            if (!was_beyond && !isinf(before)) error_beyond *= 0.5;
            before = s;
            error_before = by;
        }
        was_beyond = by > 0.0;
        if (!isinf(before)) stride = (before - beyond) / (error_beyond - error_before);
        s = beyond + stride * error_beyond;
    }
    vec3 place = s * origin + direction;
    return place == vec3(0.0) ? direction : place;
}

#endif
