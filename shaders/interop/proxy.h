// SPDX-License-Identifier: Apache-2.0
// Proxies: what stands in for the surroundings of a reflector, a box along the axes or the planes of a convex
// polyhedron. Scene space.
#ifndef UTSURI_INTEROP_PROXY_H
#define UTSURI_INTEROP_PROXY_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// A half space: dot(outward, x) <= offset.
struct ProxyPlane {
    vec3 outward;  ///< unit
    float offset;
};

struct ProxyInfo {
    vec3 lower;  ///< of the box, if there are no planes
    vec3 upper;
    uint first_plane;
    uint planes;
};

INTEROP_END
#endif
