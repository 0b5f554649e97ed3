// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where that is predicted to be right enough, and traced elsewhere.
// The including kernel defines before what that means:
//   bool look_up(Surface surface, vec3 wo, out vec3 radiance);  false where it is not right enough
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
        vec3 reflected;
        float rays = 0.0;
        if (!look_up(surface, wo, reflected)) reflected = traced_radiance(surface, wo, rays);
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) * reflected;
        found = DRAWN_LOOKED_UP + rays;
    }
    drawn = vec4(radiance, found);
}
