// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces: a mesh over each triangle of the scene, with light at its points. A triangle is the
// root of a tree of triangles. On leaves light is linear between their corners. After mesh colors (Yuksel,
// Keyser and House 2010): no parametrisation of the surface, and points only where something is.
#ifndef UTSURI_INTEROP_LIGHT_MESH_H
#define UTSURI_INTEROP_LIGHT_MESH_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// What LightMeshNode::head holds, from the lowest bits on: one of these kinds, the corner that corners are
/// counted from, how many times a node is halved, its first child.
INTEROP_CONSTANT LIGHT_MESH_LEAF = 0u;    ///< the other members are the points at its corners
INTEROP_CONSTANT LIGHT_MESH_CUT = 1u;     ///< two children: (0, split point, 2) and (split point, 1, 2)
INTEROP_CONSTANT LIGHT_MESH_HALVED = 2u;  ///< 2^halvings children: halved_child() in kept_light.glsl
INTEROP_CONSTANT LIGHT_MESH_KIND_BITS = 2u;
INTEROP_CONSTANT LIGHT_MESH_CORNER_BITS = 2u;
INTEROP_CONSTANT LIGHT_MESH_HALVINGS_BITS = 4u;

/// The roots come first, numbered like BvhTriangle.
struct LightMeshNode {
    uint head;
    uint first;  ///< leaf: point, or NONE where no light is kept; cut: bits of a float, how far along the
                 ///< edge from corner 0 to 1 it is split, in (0, 1)
    /// Leaf: points; cut: bits of floats, by how much of the triangle's barycentric coordinates b1 and b2
    /// differs what tells one child from the other, which lies between -share and 1 - share.
    uint second;
    uint third;
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
