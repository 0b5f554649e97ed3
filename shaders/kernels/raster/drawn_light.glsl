// SPDX-License-Identifier: Apache-2.0
// The surface that a fragment shows and the light it sends out, its mirror view excepted: diffuse light from the cache, what
// glossy lobes reflect from maps, and their highlights of lights without extent, which no map shows.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_LIGHT
#define UTSURI_KERNELS_RASTER_DRAWN_LIGHT

#include "kernels/glossy/glossy_lookup.glsl"
#include "kernels/light/kept_light.glsl"
#include "kernels/light/lobe_albedo.glsl"
#include "kernels/raster/drawn_surface.glsl"
#include "kernels/raster/view.glsl"
#include "kernels/scene/direct_light.glsl"
#include "lib/reservoir.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 drawn;

MaterialInfo drawn_material() {
    TextureSlotInfo none = TextureSlotInfo(NONE, 0u, 0u, 0u, 0u);
    MaterialInfo material = MaterialInfo(drawn_colour.rgb, drawn_colour.a, drawn_emissive, drawn_lobe.x, drawn_lobe.y,
                                         drawn_lobe.z, drawn_lobe.w, drawn_ids.z, none, none, none);
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
    surface.position = view.camera.origin + drawn_from_eye;
    surface.error_bound = vec3(0.0);
    surface.triangle = drawn_ids.x;
    surface.material = drawn_ids.y;
    surface.instance = NONE;
    surface.texcoord = drawn_place.zw;
    shade_surface(surface, drawn_ng, drawn_normal, drawn_material(), drawn_from_eye);
    return surface;
}

/// What the surface's diffuse part would send out if it were white, before anything is lost to a specular lobe.
/// @param place_error how far the fragment may be off on its triangle: drawn_place_error()
vec3 drawn_diffuse_light(Surface surface, vec2 place_error) {
    return kept_light(drawn_ids.x, drawn_place.xy, place_error, surface.front);
}

/// The glossy lobe's highlights of lights without extent. One is taken by what it would bring, so that noise is only where
/// some are in shadow and others not.
vec3 punctual_highlights(Surface surface, vec3 wo) {
    uint key = sampler_key(uvec2(gl_FragCoord.xy), frame.seed, frame.sample_index & 1u);
    Reservoir reservoir = empty_reservoir(sample_2d(key, frame.sample_index >> 1, 1u).x);
    Candidate taken;
    // They come before lights with extent.
    for (uint i = 0u; i < LIGHT_COUNT && lights[i].type != LIGHT_TRIANGLE; ++i) {
        if (HAS_ENVIRONMENT && i == ENVIRONMENT_LIGHT) continue;
        float probability = lights[i].probability;
        LightSample s = sample_punctual_light(lights[i], probability, surface);
        if (!is_above(surface, s.direction)) continue;
        vec3 value =
            glossy_value(surface, wo, s.direction) * s.irradiance * (probability * dot(surface.ns, s.direction));
        if (takes(reservoir, value.x + value.y + value.z)) taken = Candidate(s, value);
    }
    if (reservoir.taken == 0.0 || !is_light_visible(surface, taken.light, NONE)) return vec3(0.0);
    return taken.value * (reservoir.sum / reservoir.taken);
}

vec3 drawn_glossy_light(Surface surface, vec3 wo, vec2 place_error) {
    LobeAlbedo albedo = lobe_albedo(surface, dot(surface.ns, wo));
    vec3 normal = specular_reflectance(surface, 1.0);
    vec3 grazing = specular_reflectance(surface, 0.0);
    vec3 radiance = (normal * albedo.constant + grazing * albedo.schlick) * glossy_radiance(surface, wo, drawn_reflection);
    if (surface.metallic < 1.0) radiance += diffuse_under_lobe(surface, albedo.lost) * drawn_diffuse_light(surface, place_error);
    if (HAS_PUNCTUAL_LIGHTS) radiance += punctual_highlights(surface, wo);
    return radiance;
}

/// Rasterisers move corners to 1/256 of a pixel: where an edge of a wall hides a floor is known to this share of a pixel.
const float EDGE_ERROR = 1.0 / 128.0;

/// In barycentric coordinates. Only where all lanes of a quad run: it takes derivatives.
vec2 drawn_place_error() {
    return EDGE_ERROR * fwidth(drawn_place.xy);
}

/// @param wo unit, to the eye
vec3 drawn_light(vec3 wo, out Surface surface) {
    vec2 place_error = drawn_place_error();
    if (HAS_GLOSSY && HAS_PUNCTUAL_LIGHTS) {
        // Its shadow rays leave the surface from where rays would hit it.
        surface = make_surface(Hit(0.0, drawn_ids.x, drawn_place.x, drawn_place.y), -wo);
    } else {
        surface = drawn_surface();
    }
    if (HAS_GLOSSY && is_glossy(surface)) return surface.emission + drawn_glossy_light(surface, wo, place_error);
    return surface.emission +
           diffuse_reflectance(surface, abs(dot(surface.ns, wo))) * drawn_diffuse_light(surface, place_error);
}

#endif
