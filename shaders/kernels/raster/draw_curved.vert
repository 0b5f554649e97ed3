// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles that reflect like curved mirrors, with the maps they look up.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "lib/surface.glsl"
#include "kernels/raster/drawn_list.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "kernels/raster/drawn_vertex.glsl"
#include "kernels/raster/listed_reflector.glsl"

void main() {
    set_listed_reflector();
}
