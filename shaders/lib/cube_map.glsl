// SPDX-License-Identifier: Apache-2.0
// The cube of maps. Face 2a + s looks along axis a, downwards where s = 1; its picture's right and up are the two axes
// that follow a in cyclic order, whatever handedness that gives.
#ifndef UTSURI_LIB_CUBE_MAP
#define UTSURI_LIB_CUBE_MAP

#include "lib/numeric.glsl"

uint cube_face(vec3 direction) {
    uint axis = major_axis(direction);
    return 2u * axis + (axis_last(direction, axis).z < 0.0 ? 1u : 0u);
}

/// Picture coordinates in [-1, 1]^2 on a face of a direction (any length) that points at it: a projective division,
/// so that directions may be interpolated before it.
vec2 cube_face_position(vec3 direction, uint face) {
    vec3 d = axis_last(direction, face >> 1);
    return d.xy / abs(d.z);
}

#endif
