// SPDX-License-Identifier: Apache-2.0
// The surface that a fragment shows and the light it sends out, its mirror image excepted: diffuse light from the cache;
// rough lobes are lit by a sample of the lights. The including kernel declares the push constants, with a RasterPush push.
#include "kernels/light_cache_bindings.glsl"
#include "kernels/drawn_surface.glsl"
#include "interop/raster.h"
#include "lib/direct_light.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 drawn;

MaterialInfo drawn_material() {
    TextureSlotInfo none = TextureSlotInfo(NONE, 0u);
    MaterialInfo material = MaterialInfo(drawn_colour.rgb, drawn_colour.a, drawn_emissive, drawn_lobe.x, drawn_lobe.y,
                                         drawn_lobe.z, drawn_ids.z, none, none, none);
    if (HAS_TEXTURES) {
        material.base_colour_texture = materials[drawn_ids.y].base_colour_texture;
        material.metallic_roughness_texture = materials[drawn_ids.y].metallic_roughness_texture;
        material.emissive_texture = materials[drawn_ids.y].emissive_texture;
    }
    return material;
}

/// The surface drawn, without what only rays that leave it need.
Surface drawn_surface() {
    Surface surface;
    surface.position = push.camera.origin + drawn_from_eye;
    surface.error_bound = vec3(0.0);
    surface.triangle = drawn_ids.x;
    surface.material = drawn_ids.y;
    surface.instance = NONE;
    surface.texcoord = drawn_place.zw;
    shade_surface(surface, drawn_ng, drawn_normal, drawn_material(), drawn_from_eye);
    return surface;
}

/// What a ray of the rough lobe brings of the lights.
vec3 lobe_light(Surface surface, vec3 wo, uint key, uint index, uint dimension) {
    LobeSample lobe = sample_lobe(surface, wo, key, index, dimension);
    if (lobe.throughput == vec3(0.0)) return vec3(0.0);
    Hit hit = closest_hit(make_ray(leave_surface(surface, lobe.direction), lobe.direction, surface.triangle, NONE));
    vec3 radiance = vec3(0.0);
    if (hit.triangle != NONE) {
        radiance = make_surface(hit, lobe.direction).emission;
    } else if (HAS_ENVIRONMENT) {
        radiance = lights[ENVIRONMENT_LIGHT].intensity;
    }
    return lobe_weight(lobe, hit) * lobe.throughput * radiance;
}

/// @param wo unit, to the eye
vec3 drawn_light(vec3 wo, out Surface surface) {
    if (HAS_GLOSSY) {
        // Its rays leave the surface from where rays would hit it.
        surface = make_surface(Hit(0.0, drawn_ids.x, drawn_place.x, drawn_place.y), -wo);
        if (is_glossy(surface)) {
            uint key = sampler_key(uvec2(gl_FragCoord.xy), push.seed, push.sample_index & 1u);
            uint rays = 0u;
            return surface.emission + direct_light(surface, wo, key, push.sample_index >> 1, 1u, NONE, rays) +
                   lobe_light(surface, wo, key, push.sample_index >> 1, 1u);
        }
    } else {
        surface = drawn_surface();
    }
    LightCacheTriangle lattice = LightCacheTriangle(drawn_cache.x, drawn_cache.y, drawn_cache.z, drawn_cache.w);
    return surface.emission + diffuse_reflectance(surface, abs(dot(surface.ns, wo))) *
                                  cached_light(lattice, drawn_place.xy, dot(surface.ng, drawn_ng) > 0.0);
}
