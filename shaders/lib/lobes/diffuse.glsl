// SPDX-License-Identifier: Apache-2.0
// The Lambert lobe of the dielectric part, under what its specular lobe lets through.
#ifndef UTSURI_LIB_LOBES_DIFFUSE
#define UTSURI_LIB_LOBES_DIFFUSE

#include "lib/cosine.glsl"
#include "lib/lobes/lobe_sample.glsl"
#include "lib/reflectance.glsl"
#include "lib/scene_constants.glsl"

bool is_diffuse(Surface surface) {
    return surface.metallic < 1.0 && surface.base_colour != vec3(0.0);
}

/// 1/sr, for a direction above the surface.
vec3 diffuse_value(Surface surface, vec3 wo, vec3 wi) {
    if (!HAS_GLOSSY || !is_glossy(surface)) return diffuse_reflectance(surface, abs(dot(surface.ns, wo))) / PI;
    return diffuse_reflectance(surface, abs(dot(wo, normalize(wo + wi)))) / PI;
}

/// Density over solid angle of sample_diffuse().
float diffuse_pdf(Surface surface, vec3 wi) {
    return max(dot(surface.ns, wi), 0.0) / PI;
}

LobeSample sample_diffuse(Surface surface, vec3 wo, vec2 u) {
    vec3 wi = cosine_direction(surface.ns, u);
    if (!is_above(surface, wi)) return LobeSample(wi, vec3(0.0), 0.0);
    return LobeSample(wi, diffuse_value(surface, wo, wi) * PI, diffuse_pdf(surface, wi));
}

#endif
