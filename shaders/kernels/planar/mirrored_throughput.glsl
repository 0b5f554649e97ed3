// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows beside light: the share of what it waits for that arrives at the eye.
#ifndef UTSURI_KERNELS_PLANAR_MIRRORED_THROUGHPUT
#define UTSURI_KERNELS_PLANAR_MIRRORED_THROUGHPUT

#include "kernels/planar/mirrored_pixel.glsl"

layout(location = 1) out vec4 drawn_throughput;

#endif
