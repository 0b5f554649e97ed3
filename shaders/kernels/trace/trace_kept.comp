// SPDX-License-Identifier: Apache-2.0
// Chains from the camera with the light that leaves diffusely taken from where it is kept on surfaces, as drawn pictures take
// it; lights that glossy lobes reflect are sampled where rays meet the surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/light/kept_light.glsl"
#include "kernels/light/lobe_albedo.glsl"
#include "kernels/trace/camera_chain.glsl"

vec3 surface_light(Surface surface, Hit hit, vec3 wo, uint key, uint index, uint dimension, uint excluded_instance,
                   inout uint rays) {
    vec3 kept = kept_light(light_record(hit.triangle), vec2(hit.b1, hit.b2), surface.front);
    float cos_o = abs(dot(surface.ns, wo));
    if (!has_lobe(surface, LOBE_GLOSSY)) return diffuse_reflectance(surface, cos_o) * kept;
    return diffuse_under_lobe(surface, lobe_albedo(surface, cos_o)) * kept +
           direct_light(surface, wo, 1u << LOBE_GLOSSY, key, index, dimension, excluded_instance, rays);
}

void main() {
    render_pixel();
}
