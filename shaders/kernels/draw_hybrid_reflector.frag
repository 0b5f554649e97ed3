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

/// The direction to look up, or zero where none is right enough: that of the mirrored ray, if all that surrounds the reflector
/// is far enough for it, which costs no search; else that to where the search says the ray ends.
vec3 trusted_direction(Surface surface, vec3 wo) {
    DrawnReflection reflection = outlined_reflection(surface, wo);
    if (outline_suffices(reflection)) return reflection.ray.direction;
    reflection = drawn_reflection_of(surface, wo);
    vec3 direction = seen_along(reflection.ray, reflection.interval.guess);
    float texel = texel_angle(direction);
    Prediction prediction = predict(reflection.ray, reflection.interval, reflection.footprint, direction, direction, texel);
    return prediction.pixels <= push.tolerance ? direction : vec3(0.0);
}

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
        vec3 direction = trusted_direction(surface, wo);
        float rays = 0.0;
        vec3 reflected = direction != vec3(0.0) ? polygon_map(reflectors[drawn_ids.w].first_texel, direction)
                                                : traced_radiance(surface, wo, rays);
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) * reflected;
        found = DRAWN_LOOKED_UP + rays;
    }
    drawn = vec4(radiance, found);
}
