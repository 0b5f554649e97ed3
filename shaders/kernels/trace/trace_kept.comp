// SPDX-License-Identifier: Apache-2.0
// As the kernels that simulate light where rays meet surfaces, but that of diffuse ones is taken from where it is kept: what
// reflection maps hold.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/trace/camera_chain.glsl"
#include "kernels/trace/kept_surface_light.glsl"

void main() {
    render_pixel();
}
