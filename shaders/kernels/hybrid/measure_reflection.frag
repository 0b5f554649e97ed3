// SPDX-License-Identifier: Apache-2.0
// How wrong the look-up of a reflector is, told by the ray that it stands in for: its angle at the capture point, by how
// many pixels it is off, how far the ray goes (infinity: for ever), and whether the capture point sees what it meets (1).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/drawn_prediction.glsl"
#include "kernels/raster/shown_surface.glsl"

/// @param point where the mirrored ray meets `triangle`
bool is_seen_from_capture_point(vec3 capture_point, uint instance, vec3 point, uint triangle) {
    Ray ray = make_ray(capture_point, point - capture_point, NONE, instance);
    ray.t_max = 1.0;
    ray.excluded[1] = triangle;
    return !is_occluded(ray);
}

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface = hit_surface(wo);
    if (!is_mirror(surface)) {
        drawn = vec4(-1.0);
        return;
    }
    DrawnReflection reflection = lookup_of(surface, wo);
    SearchRay ray = reflection.ray;
    vec3 looked_up = looked_up_direction_of(surface, reflection, wanted_direction_of(surface, reflection));
    Hit hit = closest_hit(make_ray(leave_surface(surface, ray.direction), ray.direction, surface.triangle, NONE));
    float t = hit.triangle == NONE ? INFINITY : hit.t;
    float angle = angle_between(looked_up, seen_along(ray, t));
    bool seen = hit.triangle == NONE || is_seen_from_capture_point(probes[reflection.probe].capture_point, surface.instance,
                                                                   surface.position + t * ray.direction, hit.triangle);
    drawn = vec4(angle, displacement(ray, reflection.footprint, t, angle), t, seen ? 1.0 : 0.0);
}
