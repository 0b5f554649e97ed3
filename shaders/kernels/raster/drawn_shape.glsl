// SPDX-License-Identifier: Apache-2.0
// What stages that predict errors are told of the shape about a polygon.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_SHAPE
#define UTSURI_KERNELS_RASTER_DRAWN_SHAPE

#include "kernels/raster/drawn_surface.glsl"

layout(location = 9) DRAWN_FLAT float drawn_curvature;  // radians a metre, least of the edges; on the front, > 0 where convex
layout(location = 10) DRAWN_FLAT float drawn_horizon;    // sine of how high the reflector rises before the front

#endif
