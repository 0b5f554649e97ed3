// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows where nothing is.
#ifndef UTSURI_KERNELS_PLANAR_MIRRORED_ENVIRONMENT
#define UTSURI_KERNELS_PLANAR_MIRRORED_ENVIRONMENT

#include "kernels/planar/mirrored_throughput.glsl"
#include "kernels/scene/scene_bindings.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 drawn;

void draw_mirrored_environment() {
    if (!waits_for_this_view()) discard;
    drawn = with_light(lights[ENVIRONMENT_LIGHT].intensity, complete_after(view.reflections));
    drawn_throughput = vec4(0.0);
}

#endif
