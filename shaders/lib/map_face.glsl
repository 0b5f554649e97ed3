// SPDX-License-Identifier: Apache-2.0
// Finding a face of the polyhedron of maps. The including kernel declares map_faces[] and FACE_COUNT.
#ifndef UTSURI_LIB_MAP_FACE
#define UTSURI_LIB_MAP_FACE

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
