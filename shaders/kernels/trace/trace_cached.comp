// SPDX-License-Identifier: Apache-2.0
// What reflection maps hold: as direct/trace, but for diffuse surfaces, whose light is taken from where it is kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "kernels/film/film_bindings.glsl"
#include "kernels/light/light_cache_bindings.glsl"
#include "lib/direct_light.glsl"
#include "kernels/film/film_main.glsl"

#include "kernels/light/cached_surface_light.glsl"
#include "kernels/trace/specular_chain.glsl"

void main() {
    render_pixel();
}
