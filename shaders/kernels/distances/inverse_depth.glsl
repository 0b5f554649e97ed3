// SPDX-License-Identifier: Apache-2.0
// One over how far out of its face what is seen through a texel is: affine on the face where that is a plane, so that
// interpolating it between texels is exact there.
#ifndef UTSURI_KERNELS_DISTANCES_INVERSE_DEPTH
#define UTSURI_KERNELS_DISTANCES_INVERSE_DEPTH

#include "kernels/distances/distance_samples.glsl"
#include "lib/numeric.glsl"

/// @param distance as DistanceSample has it
/// @param place in texels from the border's corner
/// @returns 0 where nothing is seen
float inverse_depth(float distance, vec2 place) {
    vec2 p = (place - float(DISTANCE_BORDER)) * (2.0 / float(DISTANCE_SIZE)) - 1.0;
    return distance != 0.0 ? sqrt(1.0 + dot(p, p)) / abs(distance) : 0.0;
}

/// Of the centre of a texel.
/// @param first sample of the face
/// @param at counted from the border's corner
float inverse_depth_at(uint first, uvec2 at) {
    return inverse_depth(distance_samples[first + at.y * DISTANCE_STRIDE + at.x].centre, vec2(at) + 0.5);
}

/// Whether distances or depths about a texel are farther apart than those of a surface seen at 80 degrees (whose tangent is
/// 5.7), over the four texels of a block and its surroundings: they belong to two surfaces.
bool are_apart(float nearest, float farthest) {
    return farthest > nearest * (1.0 + 4.0 * 5.7 * 2.0 / float(DISTANCE_SIZE));
}

/// Interpolated between texels, but not between surfaces: there the nearest texel counts.
/// @param first sample of the face
/// @param texels place on the face
float interpolated_inverse_depth(uint first, vec2 texels) {
    vec2 position = texels + float(DISTANCE_BORDER) - 0.5;
    vec2 corner = clamp(floor(position), vec2(0.0), vec2(float(DISTANCE_STRIDE - 2u)));
    vec2 f = clamp(position - corner, 0.0, 1.0);
    vec4 values;
    for (int i = 0; i < 4; ++i) values[i] = inverse_depth_at(first, uvec2(corner) + uvec2(i & 1, i >> 1));
    float least = min(min(values.x, values.y), min(values.z, values.w));
    float largest = max(max(values.x, values.y), max(values.z, values.w));
    if (are_apart(least, largest)) f = round(f);
    return mix(mix(values[0], values[1], f.x), mix(values[2], values[3], f.x), f.y);
}

/// How far what is seen about a place can be off what interpolated_inverse_depth() says: the largest bend of the four by
/// four texels around it, because what is thinner than a texel may show in its neighbours only.
float inverse_depth_error(uint first, vec2 texels) {
    ivec2 corner = ivec2(floor(texels - 0.5)) - 1;
    float bend = 0.0;
    for (int i = 0; i < 16; ++i) {
        ivec2 texel = clamp(corner + ivec2(i & 3, i >> 2), ivec2(0), ivec2(int(DISTANCE_SIZE) - 1));
        uvec2 at = uvec2(texel) + DISTANCE_BORDER;
        bend = max(bend, distance_samples[first + at.y * DISTANCE_STRIDE + at.x].bend);
    }
    return bend;
}

#endif
