// SPDX-License-Identifier: Apache-2.0
// Tells the polygons of reflectors that lie within one face of their maps from those that straddle several: run once to
// mark these, and once more, when it is known how many come before each, to list both.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/specialization.h"
#include "interop/workgroup.h"
#include "kernels/maps/map_faces.glsl"
#include "kernels/reflectors/polygons.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_WRITES) const bool WRITES = false;

layout(push_constant, scalar) uniform Push { ClipPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_STRADDLING) restrict buffer Straddling { uint straddling[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN_POLYGONS) writeonly restrict buffer Straddlers { uint straddlers[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_WHOLE_PIECES) writeonly restrict buffer WholePieces { Piece whole_pieces[]; };

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    uvec3 vertices = reflector_triangles[index].vertices;
    // The vectors that point at a face form a convex cone: if a triangle's corners are in it, so is the triangle.
    uint face = map_face(vertex_reflections[vertices.x].direction);
    bool straddles = map_face(vertex_reflections[vertices.y].direction) != face ||
                     map_face(vertex_reflections[vertices.z].direction) != face;
    if (!WRITES) {
        straddling[index] = straddles ? 1u : 0u;
    } else if (straddles) {
        straddlers[straddling[index]] = index;
    } else {
        whole_pieces[index - straddling[index]] = Piece(index, face);
    }
}
