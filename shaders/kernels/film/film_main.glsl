// SPDX-License-Identifier: Apache-2.0
// The loop over the samples of a pixel.
#ifndef UTSURI_KERNELS_FILM_FILM_MAIN
#define UTSURI_KERNELS_FILM_FILM_MAIN
#include "kernels/film/counters.glsl"
#include "kernels/film/film_bindings.glsl"
#include "lib/sampler.glsl"

/// Radiance arriving along a camera ray; `key` and `index` are the sampler's. The kernel defines it.
vec3 sample_radiance(vec3 origin, vec3 direction, uint key, uint index, inout Counters totals);

void render_pixel() {
    uvec2 in_band = pixel_in_band();
    if (in_band.x >= push.width || in_band.y >= push.rows) return;
    uvec2 pixel = in_band + uvec2(0u, push.first_row);
    uint slot = in_band.y * push.width + in_band.x;
    FilmPixel state = film[slot];
    Counters totals = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    uint s = push.sample_begin;
    for (; s < push.sample_end; ++s) {
        uint key = sampler_key(pixel, push.seed, s & 1u);
        vec2 jitter = sample_2d(key, s >> 1, 0u);
        vec3 direction = camera_direction(vec2(pixel) + jitter);
        vec3 radiance = vec3(0.0);
        if (direction != vec3(0.0)) {
            radiance = sample_radiance(push.camera.origin, direction, key, s >> 1, totals);
        }
        if (is_finite(radiance)) {
            add_sample(state, s, radiance);
        } else {
            totals.nonfinite += 1u;
        }
    }
    // It cannot be, and is: Mesa's software driver ends all loops of an invocation after 65535 iterations together.
    if (s < push.sample_end) totals.incomplete = 1u;
    film[slot] = state;
    count(totals);
}

#endif
