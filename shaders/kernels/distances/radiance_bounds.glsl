// SPDX-License-Identifier: Apache-2.0
// How bright and how dark what a capture point sees along an arc of directions can be.
#ifndef UTSURI_KERNELS_DISTANCES_RADIANCE_BOUNDS
#define UTSURI_KERNELS_DISTANCES_RADIANCE_BOUNDS

#include "kernels/distances/distance_search.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_DARKEST) readonly restrict buffer Darkest { vec3 darkest[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_BRIGHTEST) readonly restrict buffer Brightest { vec3 brightest[]; };

/// Per channel.
struct RadianceBounds {
    vec3 darkest;
    vec3 brightest;
};

RadianceBounds join(RadianceBounds a, RadianceBounds b) {
    return RadianceBounds(min(a.darkest, b.darkest), max(a.brightest, b.brightest));
}

/// Over the part of an arc that lies on one face, and what is around it to a texel.
/// @param from, to its ends, as components on the face
RadianceBounds bounds_on_face(uint first_bounds, uint face, vec3 from, vec3 to) {
    ivec2 a = nearest_texel(face_texels(from));
    ivec2 b = nearest_texel(face_texels(to));
    ivec2 lower = min(a, b);
    ivec2 upper = max(a, b);
    // On a face arcs are straight: they stay between their ends. Blocks as large as that is wide are two a side.
    int extent = max(upper.x - lower.x, upper.y - lower.y);
    SearchPlace place = SearchPlace(face, extent > 1 ? uint(findMSB(extent - 1)) + 1u : 0u, lower);
    int edge = 1 << place.level;
    ivec2 last = upper >> place.level;
    RadianceBounds result = RadianceBounds(vec3(INFINITY), vec3(0.0));
    for (place.texel.y = lower.y; place.texel.y >> place.level <= last.y; place.texel.y += edge) {
        for (place.texel.x = lower.x; place.texel.x >> place.level <= last.x; place.texel.x += edge) {
            uint block = block_number(first_bounds, place);
            result = join(result, RadianceBounds(darkest[block], brightest[block]));
        }
    }
    return result;
}

/// Over all directions between two, along the shorter arc. Nothing is told of an arc over more than two faces.
/// @param from, to of any length
RadianceBounds bounds_along(uint first_bounds, vec3 from, vec3 to) {
    from = normalize_any_scale(from);
    to = normalize_any_scale(to);
    uint face = cube_face(from);
    uint next = cube_face(to);
    vec3 start = cube_components(from, face);
    if (face == next) return bounds_on_face(first_bounds, face, start, cube_components(to, face));
    // The arc crosses the plane on which vectors are as far out of one face as out of the other.
    float before = start.z - cube_components(from, next).z;
    float after = cube_components(to, face).z - cube_components(to, next).z;
    vec3 crossing = mix(from, to, before / (before - after));
    vec3 left = cube_components(crossing, face);
    // Rounding leaves the crossing this far beside the edge, at most, which is far less than a texel.
    float rounding = rounding_bound(16.0);
    if (!(max(abs(left.x), abs(left.y)) <= left.z * (1.0 + rounding))) return RadianceBounds(vec3(0.0), vec3(INFINITY));
    return join(bounds_on_face(first_bounds, face, start, left),
                bounds_on_face(first_bounds, next, cube_components(crossing, next), cube_components(to, next)));
}

/// The largest error that what is shown can have in a channel, relative to the brightest channel of what should be shown.
float relative_error(vec3 shown, RadianceBounds truth) {
    // That channel is at least this bright.
    float least = max_component(truth.darkest);
    // Where the truth is brighter than what is shown the error grows with the truth, also relative to it.
    vec3 lack = truth.brightest - shown;
    vec3 excess = shown - truth.darkest;
    float result = 0.0;
    for (int c = 0; c < 3; ++c) {
        if (lack[c] > 0.0) result = max(result, isinf(lack[c]) ? INFINITY : lack[c] / max(truth.brightest[c], least));
        if (excess[c] > 0.0) result = max(result, excess[c] / least);
    }
    return result;
}

#endif
