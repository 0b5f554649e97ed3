// SPDX-License-Identifier: Apache-2.0
// Where a ray that leaves a reflector can meet the scene, from the distances known about a capture point.
//
// What the capture point sees along a direction is empty up to the distance kept for it. A ray is in the open while it is
// nearer than that, and has met something at the latest when, without having passed behind anything, it is farther. The
// search goes along the ray over blocks of texels, larger ones where these prove it to be in the open, as rays are marched
// over minima of a height field (Uludag 2014).
#ifndef UTSURI_KERNELS_DISTANCES_DISTANCE_SEARCH
#define UTSURI_KERNELS_DISTANCES_DISTANCE_SEARCH

#include "lib/cube.glsl"
#include "kernels/distances/inverse_depth.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_DISTANCE_BOUNDS) readonly restrict buffer DistanceBoundsBuffer {
    DistanceBounds distance_bounds[];
};

/// A ray seen from the capture point.
struct SearchRay {
    vec3 origin;     ///< minus the capture point
    vec3 direction;  ///< unit
    float along;     ///< of the origin, along the direction
    float across2;   ///< square of the ray's least distance from the capture point
};

SearchRay make_search_ray(vec3 from_capture_point, vec3 direction) {
    vec3 across = cross(from_capture_point, direction);
    return SearchRay(from_capture_point, direction, dot(from_capture_point, direction), dot(across, across));
}

/// The place of a ray, from the capture point.
vec3 ray_place(SearchRay ray, float t) {
    return ray.origin + t * ray.direction;
}

/// The direction from the capture point in which a ray's place lies; infinitely far along, that of the ray.
vec3 seen_along(SearchRay ray, float t) {
    return isinf(t) ? ray.direction : ray_place(ray, t);
}

/// Where a ray that moves away from the capture point is this far from it.
float ray_at_distance(SearchRay ray, float distance) {
    return isinf(distance) ? INFINITY : -ray.along + sqrt(max(distance * distance - ray.across2, 0.0));
}

/// The ray meets the scene at t0 <= t <= t1, or never, where both are infinite. If t1 alone is, it passes behind something
/// that hides from the capture point what it meets, or meets another mirror.
struct HitInterval {
    float t0;
    float t1;
    float guess;  ///< within the interval: where what is seen beside the hiding object would go on
};

/// Whether the capture point sees what the ray meets, wherever in the interval that is, or nothing is met.
bool is_bounded(HitInterval interval) {
    return !isinf(interval.t1) || isinf(interval.t0);
}

/// Blocks that a search looks at, at most. The directions to a ray span a half circle, which crosses four faces at most;
/// these have up to 11 levels (kLargestDistanceMap), and at each a few blocks are looked at: five come to 220. A search that
/// ends here tells no bound.
const uint MOST_SEARCH_STEPS = 256u;
/// Texels over which a ray may sink into a surface, at most. Of faces of 256 texels they span 11 degrees: the error that is
/// predicted for such an interval is beyond tolerances in use, so that to go on would not save a ray.
const uint MOST_SINKING_STEPS = 32u;

/// Where the search is: a texel, and a level whose block around that texel is looked at.
struct SearchPlace {
    uint face;
    uint level;
    ivec2 texel;
};

/// The number of a block's bounds.
uint block_number(uint first_bounds, SearchPlace place) {
    uint at_level = DISTANCE_SIZE >> place.level;
    uint first = 4u * (DISTANCE_SIZE * DISTANCE_SIZE - at_level * at_level) / 3u;
    const uint BOUNDS_PER_FACE = (4u * DISTANCE_SIZE * DISTANCE_SIZE - 1u) / 3u;
    uvec2 block = uvec2(place.texel) >> place.level;
    return first_bounds + place.face * BOUNDS_PER_FACE + first + block.y * at_level + block.x;
}

DistanceBounds block_bounds(uint first_bounds, SearchPlace place) {
    return distance_bounds[block_number(first_bounds, place)];
}

/// The least of all distances about a capture point.
float least_distance(uint first_bounds) {
    SearchPlace place = SearchPlace(0u, uint(findMSB(DISTANCE_SIZE)), ivec2(0));
    float nearest = INFINITY;
    for (; place.face < DISTANCE_FACES; ++place.face) nearest = min(nearest, block_bounds(first_bounds, place).nearest);
    return nearest;
}

/// Where a place, from the capture point, lies on a face, in texels.
vec2 face_texels(vec3 components) {
    return (0.5 * float(DISTANCE_SIZE)) * (components.xy / components.z + 1.0);
}

ivec2 nearest_texel(vec2 texels) {
    return clamp(ivec2(floor(texels)), ivec2(0), ivec2(int(DISTANCE_SIZE) - 1));
}

/// Where a ray leaves the block that it is in.
struct BlockExit {
    float t;        ///< infinity where it stays
    bool beyond_x;  ///< which edge it crosses
    bool positive;
};

/// @param origin, direction components of the ray on the face
BlockExit leave_block(vec3 origin, vec3 direction, ivec2 lower, int edge, float t) {
    BlockExit result = BlockExit(INFINITY, false, false);
    for (int i = 0; i < 2; ++i) {
        // The sign of the change along the axis is the same all over the face.
        bool positive = direction[i] * origin.z > origin[i] * direction.z;
        float side = float(positive ? lower[i] + edge : lower[i]) * (2.0 / float(DISTANCE_SIZE)) - 1.0;
        float start = side * origin.z - origin[i];
        float slope = side * direction.z - direction[i];
        // The edge is where start + t slope is zero. A ray that never gets there ends within the block.
        if (positive ? slope >= 0.0 : slope <= 0.0) continue;
        float crossing = max(t, -start / slope);
        if (crossing < result.t) result = BlockExit(crossing, i == 0, positive);
    }
    return result;
}

/// The next block beyond an edge: on the neighbouring face, or a larger one where that begins there.
SearchPlace enter_block(SearchPlace place, BlockExit left, SearchRay ray, ivec2 lower, int edge, bool may_grow) {
    int axis = left.beyond_x ? 0 : 1;
    int next = left.positive ? lower[axis] + edge : lower[axis] - 1;
    vec3 there = ray_place(ray, left.t);
    if (next < 0 || next >= int(DISTANCE_SIZE)) {
        place.face = cube_neighbour(place.face, left.beyond_x, left.positive);
        place.texel = nearest_texel(face_texels(cube_components(there, place.face)));
        return place;
    }
    int other = 1 - axis;
    int along = int(floor(face_texels(cube_components(there, place.face))[other]));
    place.texel[axis] = next;
    place.texel[other] = clamp(along, lower[other], lower[other] + edge - 1);
    int parent = 2 * edge;
    bool begins = left.positive ? next % parent == 0 : (next + 1) % parent == 0;
    if (may_grow && begins && uint(parent) <= DISTANCE_SIZE) ++place.level;
    return place;
}

/// @param first_bounds of the reflector's maps
HitInterval search_distances(uint first_bounds, SearchRay ray) {
    vec3 start = ray.origin != vec3(0.0) ? ray.origin : ray.direction;
    SearchPlace place;
    place.face = cube_face(start);
    place.level = uint(findMSB(DISTANCE_SIZE)) / 2u;
    place.texel = nearest_texel(face_texels(cube_components(start, place.face)));
    float t = 0.0;
    float distance = length(ray.origin);
    bool in_the_open = true;
    bool hides = false;
    float t0 = 0.0;
    float farthest = 0.0;
    uint sinking = 0u;
    for (uint i = 0u; i < MOST_SEARCH_STEPS; ++i) {
        int edge = 1 << place.level;
        ivec2 lower = (place.texel >> place.level) << place.level;
        BlockExit left = leave_block(cube_components(ray.origin, place.face), cube_components(ray.direction, place.face),
                                     lower, edge, t);
        float left_distance = isinf(left.t) ? INFINITY : length(ray_place(ray, left.t));
        DistanceBounds bounds = block_bounds(first_bounds, place);
        bool is_open = isinf(bounds.nearest) || max(distance, left_distance) < bounds.nearest;
        if (in_the_open && !is_open) {
            if (place.level > 0u) {
                --place.level;
                continue;
            }
            in_the_open = false;
            sinking = 0u;
            farthest = 0.0;
            if (!hides) t0 = distance < bounds.nearest ? clamp(ray_at_distance(ray, bounds.nearest), t, left.t) : t;
        } else if (!in_the_open && is_open) {
            // It came out again, if it did not end.
            in_the_open = true;
            hides = true;
        }
        if (!in_the_open) {
            float block_farthest = abs(bounds.farthest);
            hides = hides || bounds.farthest < 0.0 || are_apart(bounds.nearest, block_farthest);
            if (!isinf(block_farthest)) farthest = max(farthest, block_farthest);
            float guess = max(t0, ray_at_distance(ray, farthest));
            if (!isinf(block_farthest) && left_distance >= farthest) {
                return HitInterval(t0, hides ? INFINITY : guess, guess);
            }
            if (++sinking == MOST_SINKING_STEPS) return HitInterval(t0, INFINITY, guess);
        }
        if (isinf(left.t)) return HitInterval(in_the_open && !hides ? INFINITY : t0, INFINITY, INFINITY);
        t = left.t;
        distance = left_distance;
        place = enter_block(place, left, ray, lower, edge, in_the_open);
    }
    return HitInterval(in_the_open && !hides ? t : t0, INFINITY, INFINITY);
}

/// Steps of the iteration towards the hit: on a plane the first one is exact.
const uint REFINING_STEPS = 4u;

/// Where a place, from the capture point, is kept.
struct KeptPlace {
    vec3 components;  ///< on its face
    uint first;       ///< sample of the face
};

KeptPlace kept_place(uint first_sample, vec3 place) {
    uint face = cube_face(place);
    return KeptPlace(cube_components(place, face), first_sample + face * DISTANCE_STRIDE * DISTANCE_STRIDE);
}

/// Places at which a ray is looked at for having come out.
const uint EMERGING_STEPS = 8u;

/// How far a place is beyond what the capture point sees in its direction, over its own depth.
float depth_beyond(uint first_sample, vec3 place) {
    KeptPlace kept = kept_place(first_sample, place);
    return kept.components.z * interpolated_inverse_depth(kept.first, face_texels(kept.components)) - 1.0;
}

/// Narrows an interval down to where the ray meets the distances between texels (false position, Illinois variant), give or
/// take what these can be off the surface.
HitInterval refine_hit(uint first_sample, SearchRay ray, HitInterval found) {
    if (isinf(found.guess)) return found;
    float near = found.t0;
    float far = found.guess;
    float near_value = depth_beyond(first_sample, ray_place(ray, near));
    float far_value = depth_beyond(first_sample, ray_place(ray, far));
    // Beside an edge the ray may start behind what the nearest texel shows, and come out again.
    for (uint i = 1u; i < EMERGING_STEPS && !(near_value < 0.0); ++i) {
        near = mix(found.t0, far, float(i) / float(EMERGING_STEPS));
        near_value = depth_beyond(first_sample, ray_place(ray, near));
    }
    if (!(near_value < 0.0 && far_value > 0.0)) return found;
    float slope = (far_value - near_value) / (far - near);
    for (uint i = 0u; i < REFINING_STEPS; ++i) {
        float middle = clamp((near * far_value - far * near_value) / (far_value - near_value), near, far);
        float value = depth_beyond(first_sample, ray_place(ray, middle));
        if (value < 0.0) {
            near = middle;
            near_value = value;
            far_value *= 0.5;
        } else {
            far = middle;
            far_value = value;
            near_value *= 0.5;
        }
        if (value == 0.0) break;
    }
    float t = near_value < 0.0 ? clamp((near * far_value - far * near_value) / (far_value - near_value), near, far) : far;
    if (isinf(found.t1)) return HitInterval(found.t0, INFINITY, t);
    vec3 place = ray_place(ray, t);
    KeptPlace kept = kept_place(first_sample, place);
    float error = kept.components.z * inverse_depth_error(kept.first, face_texels(kept.components)) / slope +
                  rounding_bound(64.0) * (t + length(place));
    return HitInterval(max(found.t0, t - error), min(found.t1, t + error), t);
}

#endif
