// SPDX-License-Identifier: Apache-2.0
// The corners of the polygons that lie within one face.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_piece.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_WHOLE_PIECES) readonly restrict buffer WholePieces { Piece whole_pieces[]; };

void main() {
    Piece piece = whole_pieces[uint(gl_VertexIndex) / 3u];
    uint corner = uint(gl_VertexIndex) % 3u;
    ReflectorTriangle polygon = reflector_triangles[piece.polygon];
    uint vertex = polygon.vertices[corner];
    set_drawn_piece(polygon, piece.face, PieceCorner(reflector_vertices[vertex].position,
                                                     vertex_reflections[vertex].direction, polygon.places[corner]));
}
