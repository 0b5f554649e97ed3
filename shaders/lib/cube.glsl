// SPDX-License-Identifier: Apache-2.0
// Faces of a cube about the origin, in the order of CUBE_FACES, and coordinates on them.
#ifndef UTSURI_LIB_CUBE
#define UTSURI_LIB_CUBE

#include "lib/numeric.glsl"

uint cube_face(vec3 direction) {
    uint axis = major_axis(direction);
    return 2u * axis + (direction[axis] < 0.0 ? 1u : 0u);
}

/// Components of a vector along the face and, last, out of it. The face holds (x, y) / z in [-1, 1]^2.
vec3 cube_components(vec3 v, uint face) {
    vec3 c = axis_last(v, face >> 1);
    return vec3(c.xy, (face & 1u) == 0u ? c.z : -c.z);
}

/// The reverse of cube_components().
vec3 cube_vector(vec3 c, uint face) {
    c.z = (face & 1u) == 0u ? c.z : -c.z;
    return face < 2u ? c.zxy : (face < 4u ? c.yzx : c);
}

/// The face beyond the edge x = 1 (or -1), or y = 1 (or -1), of a face.
uint cube_neighbour(uint face, bool beyond_x, bool positive) {
    uint axis = ((face >> 1) + (beyond_x ? 1u : 2u)) % 3u;
    return 2u * axis + (positive ? 0u : 1u);
}

#endif
