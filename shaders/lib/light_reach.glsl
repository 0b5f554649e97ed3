// SPDX-License-Identifier: Apache-2.0
// Whether what changed can have put a point into another light.
#ifndef UTSURI_LIB_LIGHT_REACH
#define UTSURI_LIB_LIGHT_REACH

#include "interop/light_mesh.h"
#include "lib/numeric.glsl"

/// Narrows the ways [begin, end] to those t with t * slope <= limit.
void clip_interval(float slope, float limit, inout float begin, inout float end) {
    if (slope > 0.0) end = min(end, limit / slope);
    else if (slope < 0.0) begin = max(begin, limit / slope);
    else if (limit < 0.0) end = -1.0;
}

/// Whether a straight way from a point to somewhere within the bounds of lights meets a box: the share t of all ways has
/// come as far as point + t * [lower, upper], a box that grows with t; the slab test of Kay and Kajiya (1986) for it.
bool may_block_light(ChangedBox box, vec3 point, LightBounds lights) {
    bool infinite = lights.infinite != 0u;
    vec3 lower = infinite ? lights.lower : lights.lower - point;
    vec3 upper = infinite ? lights.upper : lights.upper - point;
    float begin = 0.0;
    float end = infinite ? INFINITY : 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        clip_interval(lower[axis], box.upper[axis] - point[axis], begin, end);
        clip_interval(-upper[axis], point[axis] - box.lower[axis], begin, end);
    }
    return begin <= end;
}

#endif
