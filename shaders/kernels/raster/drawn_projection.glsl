// SPDX-License-Identifier: Apache-2.0
// Where drawn points land in the picture.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_PROJECTION
#define UTSURI_KERNELS_RASTER_DRAWN_PROJECTION

#include "kernels/raster/view.glsl"

// Passes over the same triangles must agree on their depth to the bit.
invariant gl_Position;

/// Perspective with the far plane at infinity and depth reversed, so that float32 depth is as fine far as near.
vec4 project(vec3 from_eye) {
    vec3 right = view.camera.right / dot(view.camera.right, view.camera.right);
    vec3 up = view.camera.up / dot(view.camera.up, view.camera.up);
    float w = dot(from_eye, view.camera.forward);
    // The sample's place moves to the pixel's centre, where the rasteriser samples.
    vec2 shift = (0.5 - frame.jitter) * 2.0 * frame.pixel_size;
    return vec4(dot(from_eye, right) + shift.x * w, -dot(from_eye, up) + shift.y * w, frame.near_plane, w);
}

#endif
