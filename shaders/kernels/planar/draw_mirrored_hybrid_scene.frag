// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a surface that is no mirror, its glossy lobe left to rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/deferred_lobe.glsl"
#include "kernels/planar/deferred_pixel.glsl"
#include "kernels/planar/mirrored_scene.glsl"

void main() {
    draw_mirrored_scene();
    write_deferred();
}
