// SPDX-License-Identifier: Apache-2.0
// The flat BVH: nodes of up to eight children whose boxes are quantised to eight bits relative to their
// parent (Ylitie, Karras and Laine, "Efficient incoherent ray traversal on GPUs through compressed wide
// BVHs", 2017).
#ifndef UTSURI_INTEROP_BVH_H
#define UTSURI_INTEROP_BVH_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// 80 bytes, read as five 16-byte words. Byte i of a pair of words belongs to the child in slot i.
struct BvhNode {
    /// xyz: bits of the float32 lower corner of the node's grid, in scene space.
    /// w: biased float32 exponents of the grid's cell size on x, y, z (bits 0-7, 8-15, 16-23);
    ///    bits 24-31: one bit a slot, set where the child is a node.
    uvec4 origin_exponents;
    /// x: index of the first child node; y: index of the first triangle; zw: meta byte of each slot.
    /// Meta of a node in slot s: 0x20 | (24 + s). Meta of a leaf: its triangle count in unary (1, 3 or 7) in
    /// the upper three bits, the offset of its first triangle from y in the lower five. Meta of an empty
    /// slot: 0.
    uvec4 bases_meta;
    uvec4 lower_xy;         ///< xy: lower x of the slots, in cells; zw: lower y
    uvec4 lower_z_upper_x;  ///< xy: lower z; zw: upper x
    uvec4 upper_yz;         ///< xy: upper y; zw: upper z
};

/// Vertices of a triangle in scene space. Triangles are stored in the order in which leaves refer to them,
/// and that order is the triangle index used everywhere on the device.
struct BvhTriangle {
    vec3 v0;
    vec3 v1;
    vec3 v2;
};

/// Slots of a node, and the bit of a hit mask at which nodes begin (the bits below belong to triangles).
INTEROP_CONSTANT BVH_WIDTH = 8u;
INTEROP_CONSTANT BVH_NODE_BITS = 24u;
/// Triangles in one leaf: what three unary bits of meta can say.
INTEROP_CONSTANT BVH_LEAF_TRIANGLES = 3u;
/// Depth that the builder never exceeds, in nodes from the root; it bounds the traversal stack.
INTEROP_CONSTANT BVH_MAX_DEPTH = 48u;

INTEROP_END
#endif
