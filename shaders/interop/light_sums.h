// SPDX-License-Identifier: Apache-2.0
// Lights as they are summed where light is kept, in groups: each is about one lamp.
#ifndef UTSURI_INTEROP_LIGHT_SUMS_H
#define UTSURI_INTEROP_LIGHT_SUMS_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// How many groups there are, at most.
INTEROP_CONSTANT MOST_LIGHT_GROUPS = 16u;
INTEROP_CONSTANT ALL_LIGHT_GROUPS = (1u << MOST_LIGHT_GROUPS) - 1u;  ///< a bit each

/// Lights that rays are shared out among.
struct LightGroup {
    uint reference;     ///< as LightCluster::child, to the part of the light tree that it is
    uint most_samples;  ///< 1 for one light without extent
};

/// One light. Triangles without a texture come first, then those with one, then other lights; each kind group
/// by group. 96 bytes, read as texels: the first three tell what a triangle brings that is far.
struct SummedLight {
    vec3 middle;           ///< of a triangle
    float size_squared;    ///< of its longest edge
    vec3 area;             ///< its vector area
    uint group;            ///< the one that it is in
    vec3 radiance;         ///< of a triangle without a texture, cd/m2
    uint is_double_sided;  ///< 1: it shines to both sides
    vec3 v0;               ///< vertices
    uint light;            ///< its index
    vec3 v1;
    uint first_piece;  ///< of a triangle with a texture: light_pieces.h
    vec3 v2;
    uint unused;
};

INTEROP_END
#endif
