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

/// Where a ray mirrored by a reflector can meet the scene.
/// @param leaves_front whether it leaves the front of its surface
HitInterval find_hit(DistanceMapInfo map, SearchRay ray, bool leaves_front) {
    HitInterval found = refine_hit(map.first_sample, ray, search_distances(map.first_bounds, ray));
    // Distances say nothing of the reflector itself, which a ray inside it meets, nor of what is behind a plane mirror.
    bool is_plane = map.plane_normal != vec3(0.0);
    bool is_outside = is_plane ? dot(map.plane_normal, ray.direction) > 0.0 : leaves_front;
    if (map.mirrors_itself != 0u || !is_outside) return HitInterval(0.0, INFINITY, found.guess);
    return found;
}
