// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces: a mesh over each triangle of the scene. A triangle is the root of a tree of
// triangles, on whose leaves light is linear. After mesh colors (Yuksel, Keyser and House 2010): no
// parametrisation of the surface, and light only where something is.
#ifndef UTSURI_INTEROP_LIGHT_MESH_H
#define UTSURI_INTEROP_LIGHT_MESH_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// What refers to a leaf has the first of these bits, and which of its sides are not black: those follow each
/// other among LightMeshSides from the index in the lower bits on. Else it is the index of a LightMeshSplit
/// among the texels that begin with a LightMeshRoot of each triangle.
INTEROP_CONSTANT LIGHT_MESH_LEAF = 1u << 31u;
INTEROP_CONSTANT LIGHT_MESH_FRONT = 1u << 30u;
INTEROP_CONSTANT LIGHT_MESH_BACK = 1u << 29u;
/// In LightMeshSplit::first: what tells the children apart goes up by 1 with b2; else with b1.
INTEROP_CONSTANT LIGHT_MESH_BY_B2 = 1u << 28u;
/// In LightMeshSplit::second: light may jump from child to child.
INTEROP_CONSTANT LIGHT_MESH_CUT = 1u << 28u;
INTEROP_CONSTANT LIGHT_MESH_INDEX = (1u << 28u) - 1u;

/// Of a triangle, numbered like BvhTriangle.
struct LightMeshRoot {
    uint tree;        ///< all of it, or NONE where no light is kept
    uint rows;        ///< of a grid of square cells over barycentric coordinates b1 and b2; 0 without one
    uint first_cell;  ///< a LightMeshSplit each, the first that divides the cell, or one whose parts are the
                      ///< same leaf; rows - j cells for row j of b2
    uint unused;
};

/// Two parts of a triangle, told apart by a line.
struct LightMeshSplit {
    float constant;  ///< of what is positive in the second part: + b1 + slope b2, or + slope b1 + b2
    float slope;     ///< in [-1, 1]
    uint first;
    uint second;
};

/// Light on one side of a leaf, cd/m2, in barycentric coordinates of the triangle: constant + b1 along_b1 +
/// b2 along_b2. What bounds it on the leaf: the upper half of the bits of the most, rounded up, over those of
/// the least, rounded down.
struct LightMeshSide {
    vec3 constant;
    uint red_bounds;
    vec3 along_b1;
    uint green_bounds;
    vec3 along_b2;
    uint blue_bounds;
};

/// What a white diffuse surface would send out at a point, in cd/m2: irradiance over pi.
struct LightMeshPoint {
    vec3 front;
    vec3 back;
    uint lit;  ///< groups of lights of which nothing is in shadow there: a bit each, those of the back higher
               ///< by MOST_LIGHT_GROUPS; groups that bring nothing have both bits
    uint dark;  ///< groups that are in full shadow
};

/// Where a point is.
struct LightMeshPlace {
    uint triangle;
    float b1;  ///< barycentric coordinates on it
    float b2;
    uint known;  ///< 1: what was kept at the point is right unless a change has reached it
    uint lit;  ///< groups that are lit at both ends of the edge that the place halves, bits as LightMeshPoint
               ///< has them: a few samples confirm it there
    uint dark;  ///< the same of groups that are dark
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
    uint light_bounds;     ///< how many
    uint plain_triangles;  ///< SummedLights without a texture, which are the first
    uint triangles;        ///< with those that have one
    uint changed_boxes;    ///< known points that light reaches through none of them keep what they have
};

INTEROP_END
#endif
