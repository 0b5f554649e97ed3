// SPDX-License-Identifier: Apache-2.0
// The corners of the pieces of polygons that were cut.
#version 460
#extension GL_GOOGLE_include_directive : require
#define VERTEX_STAGE
#include "kernels/raster/drawn_piece.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_CUT_PIECES) readonly restrict buffer CutPieces { Piece cut_pieces[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_CUT_CORNERS) readonly restrict buffer CutCorners { PieceCorner cut_corners[]; };

void main() {
    Piece piece = cut_pieces[uint(gl_VertexIndex) / 3u];
    set_drawn_piece(reflector_triangles[piece.polygon], piece.face, cut_corners[gl_VertexIndex]);
}
