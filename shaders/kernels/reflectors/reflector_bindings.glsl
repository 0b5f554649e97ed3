// SPDX-License-Identifier: Apache-2.0
// The polygons of reflectors, what their vertices reflect, and the polyhedron of maps.
#include "interop/reflection.h"

layout(constant_id = SPEC_FACE_COUNT) const uint FACE_COUNT = CUBE_FACES;

layout(scalar, binding = BINDING_REFLECTOR_TRIANGLES) readonly restrict buffer ReflectorTriangles {
    ReflectorTriangle reflector_triangles[];
};
layout(scalar, binding = BINDING_REFLECTOR_VERTICES) readonly restrict buffer ReflectorVertices {
    ReflectorVertex reflector_vertices[];
};
layout(scalar, binding = BINDING_VERTEX_REFLECTIONS) readonly restrict buffer VertexReflections {
    VertexReflection vertex_reflections[];
};
layout(scalar, binding = BINDING_MAP_FACES) readonly restrict buffer MapFaces { MapFace map_faces[]; };

#include "lib/map_face.glsl"
