// SPDX-License-Identifier: Apache-2.0
// The surface that a fragment shows, and where what it shows of it goes.
#ifndef UTSURI_KERNELS_RASTER_SHOWN_SURFACE
#define UTSURI_KERNELS_RASTER_SHOWN_SURFACE

#include "kernels/raster/drawn_surface.glsl"
#include "kernels/raster/view.glsl"
#include "kernels/scene/surface.glsl"
#include "lib/sampler.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 drawn;

MaterialInfo drawn_material() {
    TextureSlotInfo none = TextureSlotInfo(NONE, 0u, 0u, 0u, 0u);
    MaterialInfo material = MaterialInfo(drawn_colour.rgb, drawn_colour.a, drawn_emissive.rgb, drawn_emissive.a,
                                         drawn_lobe.rgb, drawn_lobe.a, drawn_ior, drawn_ids.z, none, none, none, none, none);
    if (HAS_TEXTURES) {
        material.base_colour_texture = materials[drawn_ids.y].base_colour_texture;
        material.metallic_roughness_texture = materials[drawn_ids.y].metallic_roughness_texture;
        material.emissive_texture = materials[drawn_ids.y].emissive_texture;
        material.specular_texture = materials[drawn_ids.y].specular_texture;
        material.specular_colour_texture = materials[drawn_ids.y].specular_colour_texture;
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

/// The same surface where rays would hit it: they leave it from there.
Surface hit_surface(vec3 wo) {
    return make_surface(Hit(0.0, drawn_ids.x, drawn_place.x, drawn_place.y), -wo);
}

/// Of the sample that is drawn: frame.sample_index >> 1 counts on within it.
uint drawn_sampler_key() {
    return sampler_key(uvec2(gl_FragCoord.xy), frame.seed, frame.sample_index & 1u);
}

#endif
