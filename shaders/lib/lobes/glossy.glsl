// SPDX-License-Identifier: Apache-2.0
// The GGX lobe of the metal and of the dielectric's surface.
#ifndef UTSURI_LIB_LOBES_GLOSSY
#define UTSURI_LIB_LOBES_GLOSSY

#include "lib/lobes/lobe_sample.glsl"
#include "lib/reflectance.glsl"

/// 1/sr, for a direction above the surface.
vec3 glossy_value(Surface surface, vec3 wo, vec3 wi) {
    vec3 h = normalize(wo + wi);
    float lobe = ggx_distribution(surface.ns, h, surface.alpha) *
                 smith_visibility(abs(dot(surface.ns, wo)), dot(surface.ns, wi), surface.alpha);
    return specular_reflectance(surface, abs(dot(wo, h))) * lobe;
}

/// Density over solid angle of sample_glossy(), directions below the surface included.
float glossy_pdf(Surface surface, vec3 wo, vec3 wi) {
    return ggx_pdf(surface.ns, normalize(wo + wi), dot(surface.ns, wo), surface.alpha);
}

/// By the normals visible from wo (Heitz 2018).
vec3 glossy_direction(Surface surface, vec3 wo, vec2 u) {
    return reflect(-wo, sample_ggx_normal(surface.ns, wo, surface.alpha, u));
}

LobeSample sample_glossy(Surface surface, vec3 wo, vec2 u) {
    vec3 wi = glossy_direction(surface, wo, u);
    if (!is_above(surface, wi)) return LobeSample(wi, vec3(0.0), 0.0);
    // Value times cosine over density, without the factors that cancel: at most the reflectance.
    vec3 throughput = specular_reflectance(surface, abs(dot(wo, normalize(wo + wi)))) *
                      smith_share(dot(surface.ns, wo), dot(surface.ns, wi), surface.alpha);
    return LobeSample(wi, throughput, glossy_pdf(surface, wo, wi));
}

#endif
