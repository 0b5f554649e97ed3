// SPDX-License-Identifier: Apache-2.0
// What reflection maps hold: as direct/trace, but for diffuse surfaces, whose light is taken from where it is kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/trace/camera_chain.glsl"
#include "kernels/trace/kept_surface_light.glsl"

void main() {
    render_pixel();
}
