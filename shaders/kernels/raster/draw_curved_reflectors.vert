// SPDX-License-Identifier: Apache-2.0
// Whole polygons of reflectors, with the shape about them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "interop/reflection.h"
#include "lib/surface.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "kernels/raster/drawn_shape.glsl"
#include "kernels/raster/drawn_vertex.glsl"
#include "kernels/reflectors/reflector_bindings.glsl"
#include "kernels/raster/drawn_reflector.glsl"
#include "kernels/reflectors/polygon_shape.glsl"

void main() {
    set_drawn_reflector();
    set_drawn_shape();
}
