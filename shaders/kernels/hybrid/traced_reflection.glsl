// SPDX-License-Identifier: Apache-2.0
// What a mirror shows, by a ray.
#ifndef UTSURI_KERNELS_HYBRID_TRACED_REFLECTION
#define UTSURI_KERNELS_HYBRID_TRACED_REFLECTION

#include "kernels/raster/drawn_surface.glsl"
#include "kernels/raster/view.glsl"
#include "kernels/trace/kept_surface_light.glsl"

struct TracedReflection {
    vec3 radiance;
    uint rays;  ///< that it took
    bool cut;   ///< at the max depth
};

/// @param reflections that lie between the surface and the eye, less than frame.max_depth
TracedReflection trace_reflection(Surface seen, vec3 wo, uint reflections) {
    // A ray leaves the surface from where rays would hit it.
    Surface surface = make_surface(Hit(0.0, seen.triangle, drawn_place.x, drawn_place.y), -wo);
    vec3 wi = mirror_direction(surface, wo);
    Counters totals = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    uint key = sampler_key(uvec2(gl_FragCoord.xy), frame.seed, frame.sample_index & 1u);
    Ray ray = make_ray(leave_surface(surface, wi), wi, surface.triangle, NONE);
    vec3 radiance = follow_chain(ray, reflections + 1u, frame.max_depth, key, frame.sample_index >> 1, totals);
    return TracedReflection(radiance, totals.rays, totals.truncated > 0u);
}

#endif
