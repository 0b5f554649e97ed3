// SPDX-License-Identifier: Apache-2.0
// The light that what a fragment shows sends out, its mirror view excepted: diffuse light from where it is kept, and what a
// glossy lobe reflects.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_LIGHT
#define UTSURI_KERNELS_RASTER_DRAWN_LIGHT

#include "kernels/light/kept_light.glsl"
#include "kernels/light/lobe_albedo.glsl"
#include "kernels/raster/shown_surface.glsl"
#include "lib/reflectance.glsl"

/// What the glossy lobe of the surface shown reflects: mapped_lobe.glsl or hybrid/deferred_lobe.glsl.
/// @param reflections that lie between the surface and the eye
/// @param state of the pixel, see pixel_state.glsl, changed where rays were needed
vec3 lobe_light(Surface surface, vec3 wo, uint reflections, inout float state);

/// Rasterisers move corners to 1/256 of a pixel: where an edge of a wall hides a floor is known to this share of a pixel.
const float EDGE_ERROR = 1.0 / 128.0;

/// How far the fragment may be off on its triangle, in barycentric coordinates. Only where all lanes of a quad run: it takes
/// derivatives.
vec2 drawn_place_error() {
    return EDGE_ERROR * fwidth(drawn_place.xy);
}

/// @param wo unit, to the eye
/// @param reflections that lie between the surface and the eye
/// @param state of the pixel, see pixel_state.glsl, changed where rays were needed
vec3 drawn_light(vec3 wo, uint reflections, out Surface surface, inout float state) {
    vec2 place_error = drawn_place_error();
    surface = drawn_surface();
    // What its diffuse part would send out if it were white, before anything is lost to a specular lobe.
    vec3 white = kept_light(drawn_ids.x, drawn_place.xy, place_error, surface.front);
    float cos_o = abs(dot(surface.ns, wo));
    if (!HAS_GLOSSY || !is_glossy(surface)) return surface.emission + diffuse_reflectance(surface, cos_o) * white;
    return surface.emission + diffuse_under_lobe(surface, lost_under_lobe(cos_o)) * white +
           lobe_light(surface, wo, reflections, state);
}

#endif
