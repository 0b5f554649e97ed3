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

/// Where the centre of a texel lies on its face, of `edge` texels, in [-1, 1]^2.
vec2 cube_place(uvec2 texel, uint edge) {
    return (vec2(texel) + 0.5) * (2.0 / float(edge)) - 1.0;
}

/// Solid angle per area of the face there.
float cube_solid_angle(vec2 p) {
    float distance2 = 1.0 + dot(p, p);
    return inversesqrt(distance2) / distance2;
}

/// Texels of the levels before one, each of half the edge of the last.
uint cube_level(uint edge, uint level) {
    uint at_level = edge >> level;
    return 8u * (edge * edge - at_level * at_level);
}

/// The face beyond the edge x = 1 (or -1), or y = 1 (or -1), of a face.
uint cube_neighbour(uint face, bool beyond_x, bool positive) {
    uint axis = ((face >> 1) + (beyond_x ? 1u : 2u)) % 3u;
    return 2u * axis + (positive ? 0u : 1u);
}

#endif
