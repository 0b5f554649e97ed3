// SPDX-License-Identifier: Apache-2.0
// The faces of the polyhedron of maps.
#ifndef UTSURI_KERNELS_MAPS_MAP_FACES
#define UTSURI_KERNELS_MAPS_MAP_FACES

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "lib/map_constants.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_MAP_FACES) uniform MapFaces { MapFace map_faces[MAP_MOST_FACES]; };

/// The face that a direction of any length points at: the first of equals.
uint map_face(vec3 direction) {
    uint face = 0u;
    float largest = dot(map_faces[0].outward, direction);
    for (uint i = 1u; i < FACE_COUNT; ++i) {
        float advance = dot(map_faces[i].outward, direction);
        if (advance > largest) {
            largest = advance;
            face = i;
        }
    }
    return face;
}

/// Homogeneous picture coordinates of a direction on a face: linear in it, so that they may be interpolated.
vec3 map_position(MapFace face, vec3 direction) {
    return vec3(dot(face.right, direction), dot(face.up, direction), dot(face.outward, direction));
}

#endif
