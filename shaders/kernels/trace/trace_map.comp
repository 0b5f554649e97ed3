// SPDX-License-Identifier: Apache-2.0
// What reflection maps hold: chains from a capture point, with the light of diffuse surfaces taken from where it is kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/trace/camera_chain.glsl"
#include "kernels/trace/map_surface_light.glsl"

void main() {
    render_pixel();
}
