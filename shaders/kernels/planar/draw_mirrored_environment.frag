// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows where nothing is.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_pixel.glsl"
#include "kernels/scene/scene_bindings.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 drawn;
layout(location = 1) out vec4 drawn_throughput;

void main() {
    if (!waits_for_this_view()) discard;
    drawn = with_light(lights[ENVIRONMENT_LIGHT].intensity, complete_after(view.reflections));
    drawn_throughput = vec4(0.0);
}
