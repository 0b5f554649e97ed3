// SPDX-License-Identifier: Apache-2.0
// Keeps what is in front of the mirror, where the mirror shows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_pixel.glsl"

layout(location = 0) in float in_front;

void main() {
    if (!(in_front > 0.0) || !waits_for_this_view()) discard;
}
