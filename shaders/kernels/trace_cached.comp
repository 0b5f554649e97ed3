// SPDX-License-Identifier: Apache-2.0
// What reflection maps hold: as direct/trace, but for diffuse surfaces, whose light is taken from where it is kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "kernels/film_bindings.glsl"
#include "kernels/light_cache_bindings.glsl"
#include "lib/direct_light.glsl"
#include "kernels/film_main.glsl"

vec3 surface_light(Surface surface, Hit hit, vec3 wo, uint key, uint index, uint dimension, inout uint rays) {
    if (HAS_GLOSSY && is_glossy(surface)) {
        return direct_light(surface, wo, key, index, dimension, push.excluded_instance, rays);
    }
    bool front = dot(surface.ng, triangle_cross(bvh_triangles[hit.triangle])) > 0.0;
    return diffuse_reflectance(surface, abs(dot(surface.ns, wo))) *
           cached_light(cache_triangles[hit.triangle], vec2(hit.b1, hit.b2), front);
}

#include "kernels/specular_chain.glsl"

void main() {
    render_pixel();
}
