// SPDX-License-Identifier: Apache-2.0
// What a mirror shows, by a ray.
#ifndef UTSURI_KERNELS_HYBRID_TRACED_REFLECTION
#define UTSURI_KERNELS_HYBRID_TRACED_REFLECTION

#include "kernels/raster/shown_surface.glsl"
#include "kernels/trace/kept_surface_light.glsl"

struct TracedReflection {
    vec3 radiance;
    uint rays;  ///< that it took
    bool cut;   ///< at the max depth
};

/// @param reflections that lie between the surface and the eye, less than frame.max_depth
TracedReflection trace_reflection(vec3 wo, uint reflections) {
    Surface surface = hit_surface(wo);
    vec3 wi = mirror_direction(surface, wo);
    Counters totals = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    Ray ray = make_ray(leave_surface(surface, wi), wi, surface.triangle, NONE);
    vec3 radiance = follow_chain(start_chain(ray, reflections + 1u), frame.max_depth, drawn_sampler_key(),
                                 frame.sample_index >> 1, totals);
    return TracedReflection(radiance, totals.rays, totals.truncated > 0u);
}

#endif
