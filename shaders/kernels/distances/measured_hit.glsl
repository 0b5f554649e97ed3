// SPDX-License-Identifier: Apache-2.0
// What the rays meet that measure what is around a capture point: two a texel, through its centre and its corner.
#ifndef UTSURI_KERNELS_DISTANCES_MEASURED_HIT
#define UTSURI_KERNELS_DISTANCES_MEASURED_HIT

#include "interop/distance_map.h"
#include "kernels/scene/traversal.glsl"
#include "lib/cube.glsl"
#include "lib/distance_constants.glsl"

struct MeasuredHit {
    vec3 direction;  ///< unit, from the capture point
    Hit hit;
    bool is_behind;  ///< the plane of a plane mirror, which can never show it
};

/// @param direction unit
MeasuredHit hit_along(MeasuredView view, vec3 direction) {
    Hit hit = closest_hit(make_ray(view.capture_point, direction, NONE, view.excluded_instance));
    bool is_plane = view.plane_normal != vec3(0.0);
    bool is_behind = is_plane && hit.triangle != NONE &&
                     dot(view.plane_normal, view.capture_point + hit.t * direction) <= view.plane_distance;
    return MeasuredHit(direction, hit, is_behind);
}

/// @param place on the face, in texels from its corner of least coordinates
MeasuredHit measured_hit(MeasuredView view, uint face, vec2 place) {
    vec2 p = place * (2.0 / float(DISTANCE_SIZE)) - 1.0;
    MeasuredHit found = hit_along(view, normalize(cube_vector(vec3(p, 1.0), face)));
    // A direction just behind the plane of a plane mirror that holds the capture point is lifted to just before it: frames
    // stand out from mirrors by so little that no other ray would meet them.
    const float BEHIND = 3.0 / float(DISTANCE_SIZE);     // a texel's diagonal, in radians, at most
    const float BEFORE = 0.0625 / float(DISTANCE_SIZE);  // 1/32 of a texel
    float elevation = dot(view.plane_normal, found.direction);
    if (!found.is_behind || abs(elevation) >= BEHIND) return found;
    return hit_along(view, normalize(found.direction + (BEFORE - elevation) * view.plane_normal));
}

/// Of a sample of a face, whose border counts: its texel, in texels from the corner of the face without border.
vec2 texel_of_sample(uint index) {
    return vec2(index % DISTANCE_STRIDE, index / DISTANCE_STRIDE) - float(DISTANCE_BORDER);
}

#endif
