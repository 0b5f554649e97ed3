// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_LIB_CAMERA
#define UTSURI_LIB_CAMERA

#include "interop/frame.h"
#include "lib/numeric.glsl"

/// Picture coordinates (x to the right, y upwards, [-1, 1]) of a position in pixels from the top left corner.
vec2 picture_position(vec2 pixels, uvec2 size) {
    return vec2(2.0, -2.0) * pixels / vec2(size) + vec2(-1.0, 1.0);
}

vec3 perspective_direction(CameraInfo camera, vec2 p) {
    return normalize_any_scale(camera.forward + p.x * camera.right + p.y * camera.up);
}

/// The direction that the OpenGL sphere map stores at p: the disc holds the mirror directions of a small chrome ball
/// seen along `forward`. The axes right and up are as long as the picture's half edge in radii of the disc. Zero outside
/// the disc.
vec3 sphere_map_direction(CameraInfo camera, vec2 p) {
    float half_edge = length(camera.right);
    vec2 q = half_edge * p;
    float r2 = dot(q, q);
    if (r2 >= 1.0) return vec3(0.0);
    vec2 xy = 2.0 * sqrt(1.0 - r2) * p;
    return normalize_any_scale(xy.x * camera.right + xy.y * camera.up - (1.0 - 2.0 * r2) * camera.forward);
}

#endif
