// SPDX-License-Identifier: Apache-2.0
// What specular_chain.glsl asks for, with the light that leaves diffusely taken from where it is kept on surfaces; lights
// that glossy lobes reflect are sampled where rays meet the surface.
#ifndef UTSURI_KERNELS_TRACE_KEPT_SURFACE_LIGHT
#define UTSURI_KERNELS_TRACE_KEPT_SURFACE_LIGHT
#include "kernels/light/kept_light.glsl"
#include "kernels/light/lobe_albedo.glsl"
#include "kernels/scene/direct_light.glsl"
#include "kernels/trace/specular_chain.glsl"

vec3 surface_light(Surface surface, Hit hit, vec3 wo, vec3 throughput, uint key, uint index, uint dimension,
                   uint excluded_instance, inout uint rays) {
    vec3 kept = kept_light(hit.triangle, vec2(hit.b1, hit.b2), RAY_PLACE_ERROR, surface.front);
    float cos_o = abs(dot(surface.ns, wo));
    if (!HAS_GLOSSY || !is_glossy(surface)) return diffuse_reflectance(surface, cos_o) * kept;
    vec3 radiance = diffuse_under_lobe(surface, lost_under_lobe(cos_o)) * kept;
    float chance = survival(throughput * specular_reflectance(surface, cos_o), LEAST_THROUGHPUT);
    if (sample_2d(key, index, dimension + 3u).y >= chance) return radiance;
    return radiance + direct_light(surface, wo, 1u << LOBE_GLOSSY, key, index, dimension, excluded_instance, rays) / chance;
}

#endif
