// SPDX-License-Identifier: Apache-2.0
// Lights that are somewhere, in a binary tree by which they are chosen for a point (Conty Estevez and Kulla,
// "Importance sampling of many lights with adaptive tree splitting", 2018).
#ifndef UTSURI_INTEROP_LIGHT_TREE_H
#define UTSURI_INTEROP_LIGHT_TREE_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Bits of LightCluster::child: it is a light, not a node; and lights shine to both sides of the axis.
INTEROP_CONSTANT LIGHT_CLUSTER_LEAF = 1u << 31u;
INTEROP_CONSTANT LIGHT_CLUSTER_BOTH_SIDES = 1u << 30u;
INTEROP_CONSTANT LIGHT_CLUSTER_INDEX = (1u << 30u) - 1u;

/// Levels of the tree, at most: the way to a light is a bit a level.
INTEROP_CONSTANT LIGHT_TREE_LEVELS = 32u;

/// One light, or some that are near each other. 32 bytes, read as two texels.
struct LightCluster {
    vec3 centre;
    float radius;      ///< of a ball that holds them, metres
    float power;       ///< of all lights, over that of the whole tree
    uint axis;         ///< unit, the middle of their normals: octahedral_axis()
    float cos_spread;  ///< of the angle from the axis within which their normals are; -1: they may be any
    uint child;        ///< index of a light or a LightTreeNode, and bits as above
};

struct LightTreeNode {
    LightCluster first;
    LightCluster second;
};

INTEROP_END
#endif
