// SPDX-License-Identifier: Apache-2.0
// The corners of the polygons that lie within one face.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "interop/reflection.h"
#include "lib/surface.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "kernels/raster/drawn_vertex.glsl"
#include "kernels/reflectors/reflector_bindings.glsl"
#include "kernels/raster/drawn_piece.glsl"

layout(scalar, binding = BINDING_WHOLE_PIECES) readonly restrict buffer WholePieces { Piece whole_pieces[]; };

void main() {
    Piece piece = whole_pieces[uint(gl_VertexIndex) / 3u];
    uint corner = uint(gl_VertexIndex) % 3u;
    ReflectorTriangle polygon = reflector_triangles[piece.polygon];
    uint vertex = polygon.vertices[corner];
    set_drawn_piece(polygon, piece.face, PieceCorner(reflector_vertices[vertex].position,
                                                     vertex_reflections[vertex].direction, polygon.places[corner]));
}
