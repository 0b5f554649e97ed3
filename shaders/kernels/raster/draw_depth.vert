// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles and nothing else: drawn first, so that only what is visible is shaded.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "interop/raster.h"
#include "kernels/raster/drawn_list.glsl"
#include "kernels/raster/drawn_vertex.glsl"

void main() {
    gl_Position = project(listed_corner() - push.camera.origin);
}
