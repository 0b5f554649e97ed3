// SPDX-License-Identifier: Apache-2.0
// The polygons of reflectors that are drawn whole.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_POLYGONS
#define UTSURI_KERNELS_RASTER_DRAWN_POLYGONS

#include "kernels/reflectors/polygons.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN_POLYGONS) readonly restrict buffer DrawnPolygons {
    uint drawn_polygons[];
};

/// The polygon that a vertex belongs to.
ReflectorTriangle drawn_polygon() {
    return reflector_triangles[drawn_polygons[uint(gl_VertexIndex) / 3u]];
}

#endif
