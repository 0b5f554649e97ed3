// SPDX-License-Identifier: Apache-2.0
// The vertices of whole polygons of reflectors.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_REFLECTOR
#define UTSURI_KERNELS_RASTER_DRAWN_REFLECTOR

#include "kernels/raster/drawn_polygons.glsl"
#include "kernels/raster/drawn_projection.glsl"
#include "kernels/raster/drawn_triangle.glsl"
#include "kernels/reflectors/polygon_probe.glsl"

void set_drawn_reflector() {
    ReflectorTriangle polygon = drawn_polygon();
    uint corner = uint(gl_VertexIndex) % 3u;
    uint vertex = polygon.vertices[corner];
    set_drawn_triangle(polygon.triangle, polygon.places[corner]);
    bool found_per_vertex = MAP_KIND == MAP_KIND_POLYGON || MAP_KIND == MAP_KIND_SPHERE;
    drawn_ids.w = found_per_vertex ? polygon_probe(polygon) : polygon.reflector;
    VertexReflection found = vertex_reflections[vertex];
    drawn_reflection = MAP_KIND == MAP_KIND_SPHERE ? vec3(found.sphere_map, 0.0) : found.direction;
    drawn_from_eye = reflector_vertices[vertex].position - view.camera.origin;
    gl_Position = project(drawn_from_eye, polygon.triangle);
}

#endif
