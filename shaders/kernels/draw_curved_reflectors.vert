// SPDX-License-Identifier: Apache-2.0
// Whole polygons of reflectors, with the shape about them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "interop/reflection.h"
#include "lib/surface.glsl"
#include "kernels/drawn_triangle.glsl"
#include "kernels/drawn_shape.glsl"
#include "kernels/drawn_vertex.glsl"
#include "kernels/reflector_bindings.glsl"
#include "kernels/drawn_reflector.glsl"
#include "kernels/polygon_shape.glsl"

void main() {
    set_drawn_reflector();
    set_drawn_shape();
}
