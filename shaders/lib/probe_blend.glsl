// SPDX-License-Identifier: Apache-2.0
// How much each of several capture points counts for what a glossy lobe reflects: weights that change steadily over a surface.
#ifndef UTSURI_LIB_PROBE_BLEND
#define UTSURI_LIB_PROBE_BLEND

/// How far from a capture point the rays of a lobe pass: root of the mean of the squares, over the rays at the lobe's median
/// angle all around. Changes by no more than the place on the surface does.
/// @param place on the surface, from the capture point
/// @param direction unit, of the lobe
float lobe_distance(vec3 place, vec3 direction, float alpha) {
    // Half of GGX's half vectors are within atan(alpha) of the normal, so half of the rays within twice that.
    float sine = 2.0 * alpha / (1.0 + alpha * alpha);
    float sine2 = sine * sine;
    float along = dot(place, direction);
    vec3 across = place - along * direction;
    return sqrt(dot(across, across) * (1.0 - 0.5 * sine2) + along * along * sine2);
}

/// Up to a factor: 1 for the point that the lobe passes nearest, 0 for those it passes farther by the width.
float blend_weight(float passes_at, float nearest, float width) {
    return max(1.0 - (passes_at - nearest) / width, 0.0);
}

#endif
