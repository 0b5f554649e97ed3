// SPDX-License-Identifier: Apache-2.0
// direct/trace: direct light with shadows, mirrors and glossy lobes followed to a depth.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/trace/camera_chain.glsl"

vec3 surface_light(Surface surface, Hit hit, vec3 wo, vec3 throughput, uint key, uint index, uint dimension,
                   uint excluded_instance, inout uint rays) {
    return direct_light(surface, wo, WIDE_LOBES, key, index, dimension, excluded_instance, rays);
}

void main() {
    render_pixel();
}
