// SPDX-License-Identifier: Apache-2.0
// The corners of the reflectors' polygons, with what the per-vertex pass found there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "interop/reflection.h"
#include "lib/surface.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "kernels/raster/drawn_vertex.glsl"
#include "kernels/reflectors/reflector_bindings.glsl"
#include "kernels/raster/drawn_reflector.glsl"

void main() {
    set_drawn_reflector();
}
