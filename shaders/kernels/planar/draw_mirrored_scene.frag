// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a surface that is no mirror.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_pixel.glsl"
#include "kernels/raster/drawn_light.glsl"

layout(location = 1) out vec4 drawn_throughput;

void main() {
    if (!waits_for_this_view()) discard;
    Surface surface;
    drawn = with_light(drawn_light(-normalize_any_scale(drawn_from_eye), surface), complete_after(view.reflections));
    drawn_throughput = vec4(0.0);
}
