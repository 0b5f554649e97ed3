// SPDX-License-Identifier: Apache-2.0
// Distances from capture points to what surrounds them. A kernel that writes them says so
// in DISTANCE_SAMPLES_ACCESS before it includes this.
#ifndef UTSURI_KERNELS_DISTANCES_DISTANCE_SAMPLES
#define UTSURI_KERNELS_DISTANCES_DISTANCE_SAMPLES

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/distance_map.h"
#include "lib/distance_constants.glsl"

#ifndef DISTANCE_SAMPLES_ACCESS
#define DISTANCE_SAMPLES_ACCESS readonly
#endif

layout(scalar, set = METHOD_SET, binding = BINDING_DISTANCE_SAMPLES) DISTANCE_SAMPLES_ACCESS restrict buffer DistanceSamples {
    DistanceSample distance_samples[];
};

#endif
