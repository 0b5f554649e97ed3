// SPDX-License-Identifier: Apache-2.0
// A box that stands in for what surrounds a reflector (Bjorke 2004).
#ifndef UTSURI_LIB_PROXY
#define UTSURI_LIB_PROXY

#include "lib/numeric.glsl"

/// Where a ray leaves a box that it starts in; its origin, if it starts outside and moves away.
vec3 leave_box(vec3 origin, vec3 direction, vec3 lower, vec3 upper) {
    float t = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        float side = direction[axis] > 0.0 ? upper[axis] : lower[axis];
        if (direction[axis] != 0.0) t = min(t, (side - origin[axis]) / direction[axis]);
    }
    return origin + max(t, 0.0) * direction;
}

#endif
