// SPDX-License-Identifier: Apache-2.0
// What glossy lobes reflect, looked up in maps, and their highlights of lights without extent, which no map shows.
#ifndef UTSURI_KERNELS_RASTER_MAPPED_LOBE
#define UTSURI_KERNELS_RASTER_MAPPED_LOBE

#include "kernels/glossy/glossy_lookup.glsl"
#include "kernels/raster/drawn_light.glsl"
#include "kernels/scene/direct_light.glsl"
#include "lib/reservoir.glsl"

/// The glossy lobe's highlights of lights without extent. One is taken by what it would bring, so that noise is only where
/// some are in shadow and others not.
vec3 punctual_highlights(vec3 wo) {
    Surface surface = hit_surface(wo);
    Reservoir reservoir = empty_reservoir(sample_2d(drawn_sampler_key(), frame.sample_index >> 1, 1u).x);
    Candidate taken;
    // They come before lights with extent.
    for (uint i = 0u; i < light_count() && lights[i].type != LIGHT_TRIANGLE; ++i) {
        if (HAS_ENVIRONMENT && i == ENVIRONMENT_LIGHT) continue;
        LightSample s = sample_punctual_light(lights[i], 1.0, surface);
        if (!is_above(surface, s.direction)) continue;
        vec3 value =
            glossy_value(surface, wo, s.direction) * s.irradiance * dot(surface.ns, s.direction);
        if (takes(reservoir, value.x + value.y + value.z)) taken = Candidate(s, value);
    }
    if (reservoir.taken == 0.0 || !is_light_visible(surface, taken.light, NONE)) return vec3(0.0);
    return taken.value * (reservoir.sum / reservoir.taken);
}

vec3 lobe_light(Surface surface, vec3 wo, uint reflections, inout float state) {
    vec3 radiance = glossy_share(surface, dot(surface.ns, wo)) * glossy_radiance(surface, wo, drawn_reflection);
    if (HAS_PUNCTUAL_LIGHTS) radiance += punctual_highlights(wo);
    return radiance;
}

#endif
