// SPDX-License-Identifier: Apache-2.0
// The polygons of reflectors, and what their vertices reflect.
#ifndef UTSURI_KERNELS_REFLECTORS_POLYGONS
#define UTSURI_KERNELS_REFLECTORS_POLYGONS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/reflection.h"

layout(scalar, set = METHOD_SET, binding = BINDING_REFLECTOR_TRIANGLES) readonly restrict buffer ReflectorTriangles {
    ReflectorTriangle reflector_triangles[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_REFLECTOR_VERTICES) readonly restrict buffer ReflectorVertices {
    ReflectorVertex reflector_vertices[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_VERTEX_REFLECTIONS) readonly restrict buffer VertexReflections {
    VertexReflection vertex_reflections[];
};

#endif
