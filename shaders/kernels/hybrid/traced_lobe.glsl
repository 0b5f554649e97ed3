// SPDX-License-Identifier: Apache-2.0
// What glossy lobes reflect, by a ray in one direction a sample and one light sample with a shadow ray; where the ray ends,
// diffuse light is taken from where it is kept.
#ifndef UTSURI_KERNELS_HYBRID_TRACED_LOBE
#define UTSURI_KERNELS_HYBRID_TRACED_LOBE

#include "kernels/hybrid/traced_reflection.glsl"
#include "kernels/raster/drawn_light.glsl"
#include "lib/pixel_state.glsl"

vec3 lobe_light(Surface seen, vec3 wo, uint reflections, inout float state) {
    Surface surface = hit_surface(wo);
    uint key = drawn_sampler_key();
    uint index = frame.sample_index >> 1;
    uint dimension = FIRST_SURFACE_DIMENSION + reflections * DIMENSIONS_PER_SURFACE;
    Counters totals = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    vec3 radiance = direct_light(surface, wo, 1u << LOBE_GLOSSY, key, index, dimension, NONE, totals.rays);
    LobeSample lobe = sample_glossy(surface, wo, sample_2d(key, index, dimension + 2u));
    if (lobe.throughput != vec3(0.0)) {
        Ray ray = make_ray(leave_surface(surface, lobe.direction), lobe.direction, surface.triangle, NONE);
        Chain chain = Chain(ray, reflections + 1u, lobe.throughput, true, lobe, receiver_of(surface));
        radiance += follow_chain(chain, frame.max_depth, key, index, totals);
    }
    // It needs none where no light and no part of the lobe is above the surface.
    if (totals.rays > 0u) state = found_by_rays(reflections, totals.rays, totals.truncated > 0u);
    return radiance;
}

#endif
