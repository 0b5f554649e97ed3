// SPDX-License-Identifier: Apache-2.0
// A plane mirror in a view; where its texture makes it rough, its lobe is traced.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/traced_lobe.glsl"
#include "kernels/planar/mirrored_mirror.glsl"

void main() {
    draw_mirrored_mirror();
}
