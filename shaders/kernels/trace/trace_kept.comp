// SPDX-License-Identifier: Apache-2.0
// Chains from the eye, or from where a reflection map is captured, lit from the light kept on surfaces.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/trace/camera_chain.glsl"
#include "kernels/trace/kept_surface_light.glsl"

void main() {
    render_pixel();
}
