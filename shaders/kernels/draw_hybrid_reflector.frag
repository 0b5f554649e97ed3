// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where that is predicted to be off by less than the tolerance, and
// traced elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/frame.h"
#include "kernels/view_push.glsl"
#include "kernels/drawn_light.glsl"
#include "kernels/map_lookup.glsl"
#include "kernels/search_bindings.glsl"
#include "kernels/drawn_prediction.glsl"
#include "kernels/cached_surface_light.glsl"
#include "kernels/specular_chain.glsl"

/// @param rays is set to how many it took
vec3 traced_radiance(Surface seen, vec3 wo, out float rays) {
    // A ray leaves the surface from where rays would hit it.
    Surface surface = make_surface(Hit(0.0, seen.triangle, drawn_place.x, drawn_place.y), -wo);
    vec3 wi = mirror_direction(surface, wo);
    Counters totals = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    uint key = sampler_key(uvec2(gl_FragCoord.xy), push.seed, push.sample_index & 1u);
    Ray ray = make_ray(leave_surface(surface, wi), wi, surface.triangle, push.excluded_instance);
    vec3 radiance = follow_chain(ray, 1u, key, push.sample_index >> 1, totals);
    rays = float(totals.rays);
    return radiance;
}

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    vec3 radiance = drawn_light(wo, surface);
    float found = DRAWN_PLAIN;
    if (is_specular(surface)) {
        DrawnReflection reflection;
        float rays = 0.0;
        vec3 reflected;
        if (find_within_tolerance(surface, wo, reflection)) {
            reflected = polygon_map(reflectors[reflection.probe].first_texel,
                                    seen_along(reflection.ray, reflection.interval.guess));
        } else {
            reflected = traced_radiance(surface, wo, rays);
        }
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) * reflected;
        found = DRAWN_LOOKED_UP + rays;
    }
    drawn = vec4(radiance, found);
}
