// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces: a mesh over each triangle of the scene, with light at its points. A triangle is the
// root of a binary tree of triangles: a line from a point on an edge of a node to the corner opposite to it
// makes its two children. On leaves light is linear between their corners. After mesh colors (Yuksel, Keyser
// and House 2010): no parametrisation of the surface, and points only where something is.
#ifndef UTSURI_INTEROP_LIGHT_MESH_H
#define UTSURI_INTEROP_LIGHT_MESH_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// LightMeshNode::split of nodes that are not split.
INTEROP_CONSTANT LIGHT_MESH_LEAF = 3u;

/// Levels of splits above a leaf, at most. Halving any triangle down to rounding takes fewer.
INTEROP_CONSTANT LIGHT_MESH_DEPTH = 192u;

/// The roots come first, numbered like BvhTriangle. Of an edge that is split, the corners are counted from
/// where it begins.
struct LightMeshNode {
    uint split;   ///< 0, 1 or 2: the edge from this corner to the next; LIGHT_MESH_LEAF
    uint first;   ///< child with corners (0, split point, 2); the one after it has (split point, 1, 2).
                  ///< Leaf: point at its first corner, or NONE where no light is kept
    uint second;  ///< bits of a float: how far along the edge it is split, in (0, 1). Leaf: point at its
                  ///< second corner
    uint third;   ///< 0. Leaf: point at its third corner
};

/// What a white diffuse surface would send out at a point, in cd/m2: irradiance over pi.
struct LightMeshPoint {
    vec3 front;
    vec3 back;
};

/// Where a point is.
struct LightMeshPlace {
    uint triangle;
    float b1;  ///< barycentric coordinates on it
    float b2;
    uint known;  ///< 1: what was kept at the point is right unless a change has reached it
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

struct LightPush {
    uint first_point;  ///< of this dispatch
    uint end_point;
    uint samples;  ///< of each point and side, at most
    uint seed;
    uint light_bounds;   ///< how many
    uint changed_boxes;  ///< known points that light reaches through none of them keep what they have
};

INTEROP_END
#endif
