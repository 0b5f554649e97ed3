// SPDX-License-Identifier: Apache-2.0
// What a drawn reflector's look-up is held against: the ray that it stands in for, where that can meet the scene, and what
// a pixel sees of the mirror.
#ifndef UTSURI_KERNELS_HYBRID_DRAWN_PREDICTION
#define UTSURI_KERNELS_HYBRID_DRAWN_PREDICTION

#include "kernels/distances/probe_search.glsl"
#include "kernels/hybrid/prediction.glsl"
#include "kernels/raster/drawn_shape.glsl"
#include "kernels/raster/map_lookup.glsl"
#include "kernels/raster/view.glsl"
#include "lib/lobes/mirror.glsl"

struct DrawnReflection {
    uint probe;
    SearchRay ray;
    HitInterval interval;
    Footprint footprint;
};

/// The angle that a pixel covers, at least: towards the picture's edges pixels are seen from farther away and slantwise.
float pixel_angle() {
    float cosine = dot(normalize_any_scale(drawn_from_eye), view.camera.forward);
    return 2.0 * length(view.camera.up) * frame.pixel_size.y * cosine * cosine;
}

bool leaves_front(Surface surface) {
    return dot(surface.ng, drawn_ng) > 0.0;
}

/// Whether a ray leaves the front more steeply than anything of the reflector rises before it.
bool misses_itself(Surface surface, vec3 wi) {
    return leaves_front(surface) && drawn_horizon < 1.0 && dot(wi, drawn_ng) > drawn_horizon;
}

Footprint drawn_footprint(Surface surface, vec3 wo) {
    float curvature = leaves_front(surface) ? drawn_curvature : -drawn_curvature;
    return make_footprint(length(drawn_from_eye), pixel_angle(), curvature, abs(dot(surface.ns, wo)));
}

DrawnReflection with_hit(ProbeHit found, Surface surface, vec3 wo) {
    return DrawnReflection(found.probe, found.ray, trusted_interval(found, misses_itself(surface, found.ray.direction)),
                           drawn_footprint(surface, wo));
}

/// With an interval that follows from the least distance of all that surrounds the reflector alone: no search.
DrawnReflection reflection_by_least_distance(Surface surface, vec3 wo) {
    vec3 wi = mirror_direction(surface, wo);
    uint probe = drawn_probe(surface, wi);
    SearchRay ray = make_search_ray(surface.position - probes[probe].capture_point, wi);
    return DrawnReflection(probe, ray, outline_hit(distance_maps[probe], ray, misses_itself(surface, wi)),
                           drawn_footprint(surface, wo));
}

DrawnReflection drawn_reflection_of(Surface surface, vec3 wo) {
    vec3 wi = mirror_direction(surface, wo);
    if (MAP_KIND == MAP_KIND_DISTANCE) return with_hit(search_probes(drawn_ids.w, surface.position, wi), surface, wo);
    return with_hit(search_probe(drawn_probe(surface, wi), surface.position, wi), surface, wo);
}

/// Whether what is seen where a reflection's interval guesses that the ray ends is predicted to be within frame.tolerance.
bool is_within_tolerance(DrawnReflection reflection) {
    vec3 direction = seen_along(reflection.ray, reflection.interval.guess);
    Prediction prediction = predict(reflection.ray, reflection.interval, reflection.footprint, direction, direction,
                                    texel_angle(reflection.probe, direction));
    return prediction.pixels <= frame.tolerance;
}

/// The cheapest look-up that is right enough: along the mirrored ray, if all that surrounds the reflector is far enough for
/// it, which costs no search; else to where the search says that the ray ends, at the probe that it passes nearest, then at
/// the others.
/// @param reflection is set to it, or to what the nearest probe tells
bool find_within_tolerance(Surface surface, vec3 wo, out DrawnReflection reflection) {
    reflection = reflection_by_least_distance(surface, wo);
    if (is_within_tolerance(reflection)) return true;
    uint nearest = reflection.probe;
    vec3 wi = reflection.ray.direction;
    reflection = with_hit(search_probe(nearest, surface.position, wi), surface, wo);
    if (is_within_tolerance(reflection)) return true;
    if (MOST_PROBES == 1u) return false;
    ProbeRange range = probe_ranges[drawn_ids.w];
    for (uint probe = range.first; probe < range.first + range.count; ++probe) {
        if (probe == nearest) continue;
        DrawnReflection other = with_hit(search_probe(probe, surface.position, wi), surface, wo);
        if (!is_within_tolerance(other)) continue;
        reflection = other;
        return true;
    }
    return false;
}

/// What the method looks up and knows. Methods other than `hybrid` have a tolerance of 0, and no texel is that small.
DrawnReflection lookup_of(Surface surface, vec3 wo) {
    if (MAP_KIND != MAP_KIND_DISTANCE || frame.tolerance == 0.0) return drawn_reflection_of(surface, wo);
    DrawnReflection reflection;
    find_within_tolerance(surface, wo, reflection);
    return reflection;
}

vec3 wanted_direction_of(Surface surface, DrawnReflection reflection) {
    if (MAP_KIND == MAP_KIND_DISTANCE) return seen_along(reflection.ray, reflection.interval.guess);
    return wanted_direction(surface, reflection.probe, reflection.ray.direction);
}

vec3 looked_up_direction_of(Surface surface, DrawnReflection reflection, vec3 wanted) {
    if (MAP_KIND == MAP_KIND_DISTANCE) return wanted;
    return looked_up_direction(surface, reflection.probe, reflection.ray.direction);
}

#endif
