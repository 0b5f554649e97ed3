// SPDX-License-Identifier: Apache-2.0
// Light kept at the points of a lattice over each triangle ("mesh colors": Yuksel, Keyser and House 2010).
// With `edge` intervals along every edge, point (i, j), i + j <= edge, has the barycentric coordinates b1 = i
// / edge, b2 = j / edge.
#ifndef UTSURI_INTEROP_LIGHT_CACHE_H
#define UTSURI_INTEROP_LIGHT_CACHE_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Indexed like BvhTriangle.
struct LightCacheTriangle {
    uint first_point;
    uint edge;  ///< intervals; 0 where the triangle keeps no light
};

/// What a white diffuse surface would send out at a point, in cd/m2: irradiance over pi.
struct LightCachePoint {
    vec3 front;
    vec3 back;
};

struct LightCachePush {
    uint first_point;  ///< of this dispatch
    uint end_point;
    uint triangles;     ///< of the scene
    uint sample_begin;  ///< samples of this dispatch: [begin, end)
    uint sample_end;
    uint samples;  ///< of each point, in all; the dispatch that takes the last one divides by it
    uint seed;
};

INTEROP_END
#endif
