// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where what they show is predicted to be less pixels off its place than
// the tolerance, and traced elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/hybrid_reflector.glsl"
#include "kernels/hybrid/look_up_by_place.glsl"

void main() {
    draw_hybrid_reflector();
}
