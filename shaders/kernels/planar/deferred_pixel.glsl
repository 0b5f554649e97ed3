// SPDX-License-Identifier: Apache-2.0
// What a pixel of a mirrored view leaves to rays, and the share of it that arrives at the eye.
#ifndef UTSURI_KERNELS_PLANAR_DEFERRED_PIXEL
#define UTSURI_KERNELS_PLANAR_DEFERRED_PIXEL

#include "kernels/hybrid/deferred_reflection.glsl"
#include "kernels/planar/mirrored_throughput.glsl"

layout(location = 2) out uvec4 drawn_deferred;

void write_deferred() {
    if (deferred.w != DEFERRED_NONE) drawn_throughput = vec4(with_reflectance(vec3(1.0)), 0.0);
    drawn_deferred = deferred;
}

#endif
