// SPDX-License-Identifier: Apache-2.0
// A pixel of the view that is drawn: whether it waits for this view, what it shows so far, and what it will show.
#ifndef UTSURI_KERNELS_PLANAR_MIRRORED_PIXEL
#define UTSURI_KERNELS_PLANAR_MIRRORED_PIXEL

#include "kernels/raster/view.glsl"
#include "lib/pixel_state.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN) readonly restrict buffer Drawn { vec4 drawn_before[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_THROUGHPUT) readonly restrict buffer Throughputs { vec4 throughput_before[]; };

uint pixel_index() {
    return uint(gl_FragCoord.y) * frame.width + uint(gl_FragCoord.x);
}

bool waits_for_this_view() {
    return view.number == VIEW_OF_EYE || drawn_before[pixel_index()].a == waiting_for(view.number);
}

/// What a pixel shows with some more light, and the state it is in then.
vec4 with_light(vec3 radiance, float state) {
    if (view.number == VIEW_OF_EYE) return vec4(radiance, state);
    uint pixel = pixel_index();
    return vec4(drawn_before[pixel].rgb + throughput_before[pixel].rgb * radiance, state);
}

/// Share of what is seen next that arrives at the eye.
vec3 with_reflectance(vec3 reflectance) {
    return view.number == VIEW_OF_EYE ? reflectance : throughput_before[pixel_index()].rgb * reflectance;
}

#endif
