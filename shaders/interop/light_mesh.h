// SPDX-License-Identifier: Apache-2.0
// Light kept at points in rows over each triangle (after the mesh colors of Yuksel, Keyser and House 2010,
// whose lattices are as fine along the short edges of a triangle as along its long ones). Rows run along the
// shortest edge, the base, from that edge to the apex, the corner opposite to it. The base's row has
// `intervals` intervals; each `rows_per_interval` rows later there is one less, until the apex is a row of
// one point.
#ifndef UTSURI_INTEROP_LIGHT_CACHE_H
#define UTSURI_INTEROP_LIGHT_CACHE_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Indexed like BvhTriangle.
struct LightCacheTriangle {
    uint first_point;
    uint intervals;          ///< of the base; 0 where the triangle keeps no light
    uint rows_per_interval;  ///< at least 1
    uint apex;               ///< 0, 1 or 2; the base goes from the corner after it to the one before it
};

/// What a white diffuse surface would send out at a point, in cd/m2: irradiance over pi.
struct LightCachePoint {
    vec3 front;
    vec3 back;
};

/// Where light comes from.
struct LightBounds {
    uint infinite;  ///< 0: the box holds lights; 1: it holds directions to lights
    vec3 lower;
    vec3 upper;
};

/// A box in which things changed, with room for the rounding of rays.
struct ChangedBox {
    vec3 lower;
    vec3 upper;
};

struct LightCachePush {
    uint first_point;  ///< of this dispatch
    uint end_point;
    uint triangles;  ///< of the scene
    uint samples;    ///< of each point and side, at most
    uint seed;
    uint light_bounds;   ///< how many
    uint changed_boxes;  ///< points that light reaches through none of them keep what they have
};

INTEROP_END
#endif
