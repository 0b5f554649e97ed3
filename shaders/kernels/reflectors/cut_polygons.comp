// SPDX-License-Identifier: Apache-2.0
// Cuts the polygons that straddle faces along their boundaries: run once to count the pieces of each polygon, and once
// more, when it is known where they go, to write them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/specialization.h"
#include "interop/workgroup.h"
#include "kernels/reflectors/clip.glsl"
#include "kernels/reflectors/polygons.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_WRITES) const bool WRITES = false;

layout(push_constant, scalar) uniform Push { ClipPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_STRADDLING) readonly restrict buffer Straddling { uint straddling[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN_POLYGONS) readonly restrict buffer Straddlers { uint straddlers[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_CUT_COUNTS) restrict buffer CutCounts { uint cut_counts[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_CUT_PIECES) writeonly restrict buffer CutPieces { Piece cut_pieces[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_CUT_CORNERS) writeonly restrict buffer CutCorners { PieceCorner cut_corners[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DRAW_ARGUMENTS) writeonly restrict buffer Arguments { DrawArguments arguments[3]; };

ReflectedTriangle reflected_triangle(ReflectorTriangle polygon) {
    ReflectedTriangle triangle;
    for (int i = 0; i < 3; ++i) {
        triangle.positions[i] = reflector_vertices[polygon.vertices[i]].position;
        triangle.reflections[i] = vertex_reflections[polygon.vertices[i]].direction;
    }
    return triangle;
}

PieceCorner piece_corner(ReflectorTriangle polygon, ReflectedTriangle triangle, uint name) {
    PieceCornerWeights weights = corner_weights(triangle, name);
    vec3 b = weights.barycentric;
    return PieceCorner(at_piece_corner(weights, triangle.positions), at_piece_corner(weights, triangle.reflections),
                       b.x * polygon.places[0] + b.y * polygon.places[1] + b.z * polygon.places[2]);
}

/// A convex polygon as a fan.
/// @returns the slot after its pieces
uint write_part(uint slot, uint index, ReflectorTriangle polygon, ReflectedTriangle triangle, uint face) {
    PieceCorner first = piece_corner(polygon, triangle, part_names[0]);
    PieceCorner previous = piece_corner(polygon, triangle, part_names[1]);
    for (uint c = 2u; c < part_count; ++c, ++slot) {
        PieceCorner next = piece_corner(polygon, triangle, part_names[c]);
        // Pieces beyond the room there is stay away: the pass that fills gaps draws what they would have covered.
        if (slot < push.most_cut) {
            cut_pieces[slot] = Piece(index, face);
            cut_corners[3u * slot] = first;
            cut_corners[3u * slot + 1u] = previous;
            cut_corners[3u * slot + 2u] = next;
        }
        previous = next;
    }
    return slot;
}

void main() {
    uint straddler = push.begin + gl_GlobalInvocationID.x;
    if (straddler >= push.end) return;
    uint straddler_count = straddling[push.polygons];
    if (WRITES && straddler == 0u) {
        arguments[0] = DrawArguments(3u * (push.polygons - straddler_count), 1u, 0u, 0u);
        arguments[1] = DrawArguments(3u * min(cut_counts[push.polygons], push.most_cut), 1u, 0u, 0u);
        arguments[2] = DrawArguments(3u * straddler_count, 1u, 0u, 0u);
    }
    if (straddler >= straddler_count) {
        if (!WRITES) cut_counts[straddler] = 0u;
        return;
    }
    uint index = straddlers[straddler];
    ReflectorTriangle polygon = reflector_triangles[index];
    ReflectedTriangle triangle = reflected_triangle(polygon);
    uint slot = 0u;
    if (WRITES) slot = cut_counts[straddler];
    // Neighbouring invocations cut to whatever face is next for each, instead of all waiting for each face.
    for (uint met = faces_met(triangle, push.faces); met != 0u; met &= met - 1u) {
        uint face = uint(findLSB(met));
        cut_to_face(triangle, face, push.faces);
        if (part_count < 3u) continue;
        if (WRITES) {
            slot = write_part(slot, index, polygon, triangle, face);
        } else {
            slot += part_count - 2u;
        }
    }
    if (!WRITES) cut_counts[straddler] = slot;
}
