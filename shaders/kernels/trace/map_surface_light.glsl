// SPDX-License-Identifier: Apache-2.0
// What specular_chain.glsl asks for, with the light of diffuse surfaces taken from where it is kept.
#ifndef UTSURI_KERNELS_TRACE_MAP_SURFACE_LIGHT
#define UTSURI_KERNELS_TRACE_MAP_SURFACE_LIGHT
#include "kernels/light/kept_light.glsl"
#include "kernels/scene/direct_light.glsl"
#include "kernels/trace/specular_chain.glsl"

vec3 surface_light(Surface surface, Hit hit, vec3 wo, uint key, uint index, uint dimension, uint excluded_instance,
                   inout uint rays) {
    if (HAS_GLOSSY && is_glossy(surface)) {
        return direct_light(surface, wo, WIDE_LOBES, key, index, dimension, excluded_instance, rays);
    }
    return diffuse_reflectance(surface, abs(dot(surface.ns, wo))) *
           kept_light(light_record(hit.triangle), vec2(hit.b1, hit.b2), surface.front);
}

#endif
