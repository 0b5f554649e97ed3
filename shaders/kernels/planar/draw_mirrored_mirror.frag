// SPDX-License-Identifier: Apache-2.0
// A plane mirror in a view; where its texture makes it rough, its lobe is looked up.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/planar/mirrored_mirror.glsl"
#include "kernels/raster/mapped_lobe.glsl"

void main() {
    draw_mirrored_mirror();
}
