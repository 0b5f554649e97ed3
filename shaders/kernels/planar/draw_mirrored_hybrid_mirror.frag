// SPDX-License-Identifier: Apache-2.0
// A plane mirror in a view. Where its own view is not drawn, and where its texture makes it rough, rays are left to follow.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/deferred_lobe.glsl"
#include "kernels/planar/deferred_pixel.glsl"
#include "kernels/planar/mirrored_mirror.glsl"

void main() {
    bool lacks_view = draw_mirrored_mirror();
    if (lacks_view && view.reflections < frame.max_depth) defer_mirror(DEFERRED_PLANE_MIRROR);
    write_deferred();
}
