// SPDX-License-Identifier: Apache-2.0
// A box or a convex polyhedron that stands in for what surrounds a reflector (Bjorke 2004). Rays start inside, but for
// what of a reflector reaches out: a ray from there leaves on the far side if it comes back in, and else has left where it
// starts, so that what is looked up changes steadily.
#ifndef UTSURI_LIB_PROXY
#define UTSURI_LIB_PROXY

#include "interop/proxy.h"
#include "lib/numeric.glsl"

/// Where a ray leaves a box.
vec3 leave_box(vec3 origin, vec3 direction, vec3 lower, vec3 upper) {
    float t = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        float side = direction[axis] > 0.0 ? upper[axis] : lower[axis];
        if (direction[axis] != 0.0) t = min(t, (side - origin[axis]) / direction[axis]);
    }
    return origin + max(t, 0.0) * direction;
}

/// How far along a ray leaves a half space; no farther than t.
float leave_half_space(float t, vec3 origin, vec3 direction, ProxyPlane plane) {
    float towards = dot(plane.outward, direction);
    return towards > 0.0 ? min(t, (plane.offset - dot(plane.outward, origin)) / towards) : t;
}

/// The direction in which `point` sees a place where a ray along `direction` leaves a proxy; that of the ray, where it
/// leaves at the point itself.
vec3 direction_to(vec3 place, vec3 point, vec3 direction) {
    return place != point ? place - point : direction;
}

#endif
