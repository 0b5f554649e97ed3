// SPDX-License-Identifier: Apache-2.0
// The distances about the capture points of reflectors, and the search for what a mirrored ray meets.
#include "interop/distance_map.h"

layout(constant_id = SPEC_DISTANCE_SIZE) const uint DISTANCE_SIZE = 256u;

layout(scalar, binding = BINDING_DISTANCE_MAPS) readonly restrict buffer DistanceMaps { DistanceMapInfo distance_maps[]; };
layout(scalar, binding = BINDING_DISTANCE_SAMPLES) readonly restrict buffer DistanceSamples {
    DistanceSample distance_samples[];
};
layout(scalar, binding = BINDING_DISTANCE_BOUNDS) readonly restrict buffer DistanceBoundsBuffer {
    DistanceBounds distance_bounds[];
};

#include "lib/distance_search.glsl"

/// Whether distances say what a ray can meet: they say nothing of the reflector itself, which a ray inside it meets, nor of
/// what is behind a plane mirror.
/// @param leaves_front whether the ray leaves the front of the reflector
bool distances_tell(DistanceMapInfo map, SearchRay ray, bool leaves_front) {
    bool is_plane = map.plane_normal != vec3(0.0);
    bool is_outside = is_plane ? dot(map.plane_normal, ray.direction) > 0.0 : leaves_front;
    return map.mirrors_itself == 0u && is_outside;
}

/// Where a ray mirrored by a reflector can meet the scene.
HitInterval find_hit(DistanceMapInfo map, SearchRay ray, bool leaves_front) {
    HitInterval found = refine_hit(map.first_sample, ray, search_distances(map.first_bounds, ray));
    if (!distances_tell(map, ray, leaves_front)) return HitInterval(0.0, INFINITY, found.guess);
    return found;
}

/// The same from the least of all distances alone: not closer than that.
HitInterval outline_hit(DistanceMapInfo map, SearchRay ray, bool leaves_front) {
    float nearest = least_distance(map.first_bounds);
    if (!distances_tell(map, ray, leaves_front) || length(ray.origin) >= nearest) return HitInterval(0.0, INFINITY, INFINITY);
    return HitInterval(ray_at_distance(ray, nearest), INFINITY, INFINITY);
}
