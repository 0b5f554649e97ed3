// SPDX-License-Identifier: Apache-2.0
// A list of rays to trace, for tests and benchmarks.
#ifndef UTSURI_INTEROP_RAYS_H
#define UTSURI_INTEROP_RAYS_H
#include "interop/prelude.h"
INTEROP_BEGIN

struct RayInfo {
    vec3 origin;
    vec3 direction;  ///< any length; distances are in multiples of it
    float t_max;
    uint excluded;  ///< triangle that the ray passes through, or NONE
};

struct HitInfo {
    float t;        ///< infinity where nothing is hit
    uint triangle;  ///< device order, or NONE
    float b1;       ///< barycentric coordinates of the second and third vertex
    float b2;
};

struct TraceRaysPush {
    uint first;
    uint count;
};

INTEROP_END
#endif
