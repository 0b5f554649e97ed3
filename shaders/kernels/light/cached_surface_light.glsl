// SPDX-License-Identifier: Apache-2.0
// What specular_chain.glsl asks for, with the light of diffuse surfaces taken from where it is kept.

vec3 surface_light(Surface surface, Hit hit, vec3 wo, uint key, uint index, uint dimension, inout uint rays) {
    if (HAS_GLOSSY && is_glossy(surface)) {
        return direct_light(surface, wo, key, index, dimension, push.excluded_instance, rays);
    }
    bool front = dot(surface.ng, triangle_cross(bvh_triangles[hit.triangle])) > 0.0;
    return diffuse_reflectance(surface, abs(dot(surface.ns, wo))) *
           cached_light(cache_triangles[hit.triangle], vec2(hit.b1, hit.b2), front);
}
