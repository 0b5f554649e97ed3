// SPDX-License-Identifier: Apache-2.0
// direct/trace: direct light with shadows, mirrors and rough lobes followed to a depth.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "kernels/film/film_bindings.glsl"
#include "lib/direct_light.glsl"
#include "kernels/film/film_main.glsl"

vec3 surface_light(Surface surface, Hit hit, vec3 wo, uint key, uint index, uint dimension, inout uint rays) {
    return direct_light(surface, wo, key, index, dimension, push.excluded_instance, rays);
}

#include "kernels/trace/specular_chain.glsl"

void main() {
    render_pixel();
}
