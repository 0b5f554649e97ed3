// SPDX-License-Identifier: Apache-2.0
// The distances about the capture points of reflectors, and the search for what a mirrored ray meets.
#ifndef UTSURI_KERNELS_DISTANCES_PROBE_SEARCH
#define UTSURI_KERNELS_DISTANCES_PROBE_SEARCH

#include "kernels/distances/distance_search.glsl"
#include "kernels/maps/probes.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_DISTANCE_MAPS) readonly restrict buffer DistanceMaps {
    DistanceMapInfo distance_maps[];
};

/// Whether distances say what a ray can meet: they say nothing of the reflector itself, nor of what is behind a plane mirror.
/// @param misses_itself whether the ray cannot meet the reflector again, if that is no plane
bool distances_are_valid(DistanceMapInfo map, SearchRay ray, bool misses_itself) {
    bool is_plane = map.plane_normal != vec3(0.0);
    return is_plane ? dot(map.plane_normal, ray.direction) > 0.0 : misses_itself;
}

/// What a search in the distances of one probe finds.
struct ProbeHit {
    uint probe;
    SearchRay ray;
    HitInterval interval;  ///< as if distances told all: see trusted_interval()
};

ProbeHit search_probe(uint probe, vec3 position, vec3 direction) {
    SearchRay ray = make_search_ray(position - probes[probe].capture_point, direction);
    DistanceMapInfo map = distance_maps[probe];
    return ProbeHit(probe, ray, refine_hit(map.first_sample, ray, search_distances(map.first_bounds, ray)));
}

/// The first probe that sees what a ray meets, beginning with that which the ray passes nearest; that one if none does.
ProbeHit search_probes(uint reflector, vec3 position, vec3 direction) {
    ProbeHit nearest = search_probe(nearest_probe(reflector, position, direction), position, direction);
    if (MOST_PROBES == 1u || is_bounded(nearest.interval)) return nearest;
    ProbeRange range = probe_ranges[reflector];
    for (uint probe = range.first; probe < range.first + range.count; ++probe) {
        if (probe == nearest.probe) continue;
        ProbeHit other = search_probe(probe, position, direction);
        if (is_bounded(other.interval)) return other;
    }
    return nearest;
}

/// Where a ray mirrored by a reflector can meet the scene.
HitInterval trusted_interval(ProbeHit found, bool misses_itself) {
    if (distances_are_valid(distance_maps[found.probe], found.ray, misses_itself)) return found.interval;
    return HitInterval(0.0, INFINITY, found.interval.guess);
}

/// The same from the least of all distances of a probe alone: not closer than that.
HitInterval outline_hit(DistanceMapInfo map, SearchRay ray, bool misses_itself) {
    float nearest = least_distance(map.first_bounds);
    if (!distances_are_valid(map, ray, misses_itself) || length(ray.origin) >= nearest) return HitInterval(0.0, INFINITY, INFINITY);
    return HitInterval(ray_at_distance(ray, nearest), INFINITY, INFINITY);
}

#endif
