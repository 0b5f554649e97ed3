// SPDX-License-Identifier: Apache-2.0
// Sets what a vertex of a piece tells: homogeneous coordinates on one face of the polyhedron of maps.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_PIECE
#define UTSURI_KERNELS_RASTER_DRAWN_PIECE

#include "kernels/maps/map_faces.glsl"
#include "kernels/raster/drawn_projection.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "kernels/reflectors/polygon_probe.glsl"

void set_drawn_piece(ReflectorTriangle polygon, uint face, PieceCorner corner) {
    set_drawn_triangle(polygon.triangle, corner.place);
    drawn_ids.w = polygon_probe(polygon) * FACE_COUNT + face;
    drawn_reflection = map_position(map_faces[face], corner.reflection);
    drawn_from_eye = corner.position - view.camera.origin;
    gl_Position = project(drawn_from_eye, polygon.triangle);
}

#endif
