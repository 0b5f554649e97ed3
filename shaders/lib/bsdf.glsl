// SPDX-License-Identifier: Apache-2.0
// The glTF 2.0 metallic-roughness BRDF (specification, appendix B): a Lambert and a GGX lobe for the dielectric part,
// a GGX lobe for the metal. Directions wo and wi leave the surface.
#ifndef UTSURI_LIB_BSDF
#define UTSURI_LIB_BSDF

#include "lib/microfacet.glsl"
#include "lib/scene_constants.glsl"
#include "lib/surface.glsl"

float dielectric_fresnel(Surface surface, float cosine) {
    return schlick(vec3(surface.f0), vec3(surface.f90), cosine).x;
}

/// Reflectance of the specular lobe at the angle between direction and (micro)facet normal.
vec3 specular_reflectance(Surface surface, float cosine) {
    vec3 metal = schlick(surface.base_colour, vec3(1.0), cosine);
    return mix(vec3(dielectric_fresnel(surface, cosine)), metal, surface.metallic);
}

/// Share of the light that arrives which leaves diffusely towards a viewer at this cosine, where nothing is glossy.
vec3 diffuse_reflectance(Surface surface, float cos_o) {
    return surface.base_colour * ((1.0 - surface.metallic) * (1.0 - dielectric_fresnel(surface, cos_o)));
}

bool has_specular_lobe(Surface surface) {
    return surface.metallic > 0.0 || surface.f0 > 0.0 || surface.f90 > 0.0;
}

bool is_glossy(Surface surface) {
    return surface.alpha > 0.0 && has_specular_lobe(surface);
}

bool is_specular(Surface surface) {
    return surface.alpha == 0.0 && has_specular_lobe(surface);
}

/// Whether a direction leaves the surface on the viewer's side.
bool is_above(Surface surface, vec3 wi) {
    return dot(surface.ns, wi) > 0.0 && dot(surface.ng, wi) > 0.0;
}

/// The Lambert lobe, 1/sr, for a direction above the surface.
vec3 diffuse_lobe(Surface surface, vec3 wo, vec3 wi) {
    if (!HAS_GLOSSY || !is_glossy(surface)) return diffuse_reflectance(surface, abs(dot(surface.ns, wo))) / PI;
    return diffuse_reflectance(surface, abs(dot(wo, normalize(wo + wi)))) / PI;
}

/// The rough specular lobe of a glossy surface, 1/sr, for a direction above the surface.
vec3 glossy_lobe(Surface surface, vec3 wo, vec3 wi) {
    vec3 h = normalize(wo + wi);
    float lobe = ggx_distribution(surface.ns, h, surface.alpha) *
                 smith_visibility(abs(dot(surface.ns, wo)), dot(surface.ns, wi), surface.alpha);
    return specular_reflectance(surface, abs(dot(wo, h))) * lobe;
}

/// A direction by the glossy lobe, which may lie below the surface.
vec3 sample_glossy(Surface surface, vec3 wo, vec2 u) {
    return reflect(-wo, sample_ggx_normal(surface.ns, wo, surface.alpha, u));
}

/// Density over solid angle of sample_glossy().
float glossy_pdf(Surface surface, vec3 wo, vec3 wi) {
    return ggx_pdf(surface.ns, normalize(wo + wi), dot(surface.ns, wo), surface.alpha);
}

/// glossy_lobe() times cosine over glossy_pdf(), without the factors that cancel: at most the reflectance.
vec3 glossy_throughput(Surface surface, vec3 wo, vec3 wi) {
    return specular_reflectance(surface, abs(dot(wo, normalize(wo + wi)))) *
           smith_share(dot(surface.ns, wo), dot(surface.ns, wi), surface.alpha);
}

/// The mirrored direction. Near silhouettes an interpolated normal can mirror the ray into the surface; it is mirrored
/// out again at the geometric plane, which is continuous.
vec3 mirror_direction(Surface surface, vec3 wo) {
    vec3 wi = reflect(-wo, surface.ns);
    float below = dot(wi, surface.ng);
    return below < 0.0 ? wi - 2.0 * below * surface.ng : wi;
}

#endif
