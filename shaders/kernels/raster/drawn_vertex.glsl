// SPDX-License-Identifier: Apache-2.0
// Where drawn points land in the picture of one view.
#include "kernels/raster/view_push.glsl"
#include "kernels/raster/drawn_projection.glsl"
