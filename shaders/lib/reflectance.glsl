// SPDX-License-Identifier: Apache-2.0
// Shares of light that the parts of a glTF 2.0 metallic-roughness material reflect (specification, appendix B).
#ifndef UTSURI_LIB_REFLECTANCE
#define UTSURI_LIB_REFLECTANCE

#include "lib/microfacet.glsl"
#include "lib/surface.glsl"

vec3 dielectric_fresnel(Surface surface, float cosine) {
    return schlick(surface.f0, vec3(surface.f90), cosine);
}

/// Of the specular lobe, at the angle between direction and (micro)facet normal.
vec3 specular_reflectance(Surface surface, float cosine) {
    vec3 metal = schlick(surface.base_colour, vec3(1.0), cosine);
    return mix(dielectric_fresnel(surface, cosine), metal, surface.metallic);
}

/// Share of the light that arrives which leaves diffusely towards a viewer at this cosine, where nothing is glossy. A coloured
/// dielectric takes from all colours what it reflects of the one that it reflects most (KHR_materials_specular).
vec3 diffuse_reflectance(Surface surface, float cos_o) {
    return surface.base_colour * ((1.0 - surface.metallic) * (1.0 - max_component(dielectric_fresnel(surface, cos_o))));
}

bool reflects_specularly(Surface surface) {
    return surface.metallic > 0.0 || surface.f90 > 0.0;
}

/// Whether the specular part is a lobe with a width, which glossy.glsl samples.
bool is_glossy(Surface surface) {
    return surface.alpha > 0.0 && reflects_specularly(surface);
}

/// Whether it is a single direction: mirror.glsl.
bool is_mirror(Surface surface) {
    return surface.alpha == 0.0 && reflects_specularly(surface);
}

#endif
