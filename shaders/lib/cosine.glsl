// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_LIB_COSINE
#define UTSURI_LIB_COSINE

#include "lib/basis.glsl"
#include "lib/trigonometry.glsl"

/// A direction about the unit vector n whose density over solid angle is its cosine to n, over pi.
/// @param u uniform in [0, 1)^2
vec3 cosine_direction(vec3 n, vec2 u) {
    vec3 tangent, bitangent;
    make_basis(n, tangent, bitangent);
    vec2 disc = sqrt(u.x) * cos_sin_of_turn(u.y);
    return disc.x * tangent + disc.y * bitangent + sqrt(1.0 - u.x) * n;
}

#endif
