// SPDX-License-Identifier: Apache-2.0
// What glossy lobes reflect is left to rays, where it is little by chance: most of a room of dielectrics reflects 4 %, and its
// rays would take most of the time.
#ifndef UTSURI_KERNELS_HYBRID_DEFERRED_LOBE
#define UTSURI_KERNELS_HYBRID_DEFERRED_LOBE

#include "kernels/hybrid/deferred_reflection.glsl"
#include "kernels/raster/drawn_light.glsl"
#include "lib/roulette.glsl"
#include "lib/sampler.glsl"

/// Share of the light met that a lobe brings, once it is followed, at least. With 1/32, as chains have it, a sample takes up to
/// twice as long, and the noise for the time is a tenth less; with 1/4 it is two fifths more: benchmarks/README.md.
const float LEAST_LOBE = 1.0 / 8.0;

vec3 lobe_light(Surface surface, vec3 wo, uint reflections, inout float state) {
    uint chances = uint(ceil(survival(glossy_share(surface, dot(surface.ns, wo)), LEAST_LOBE) * float(DEFERRED_CHANCES)));
    uint dimension = FIRST_SURFACE_DIMENSION + reflections * DIMENSIONS_PER_SURFACE + 3u;
    float u = sample_2d(drawn_sampler_key(), frame.sample_index >> 1, dimension).x;
    if (u * float(DEFERRED_CHANCES) < float(chances)) defer_reflection(DEFERRED_LOBE, max(chances, 1u));
    return vec3(0.0);
}

#endif
