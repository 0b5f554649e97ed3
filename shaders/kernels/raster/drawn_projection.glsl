// SPDX-License-Identifier: Apache-2.0
// Where drawn points land in the picture. The including kernel declares the push constants, with a RasterPush push.

// Passes over the same triangles must agree on their depth to the bit.
invariant gl_Position;

/// Perspective with the far plane at infinity and depth reversed, so that float32 depth is as fine far as near.
vec4 project(vec3 from_eye) {
    vec3 right = push.camera.right / dot(push.camera.right, push.camera.right);
    vec3 up = push.camera.up / dot(push.camera.up, push.camera.up);
    float w = dot(from_eye, push.camera.forward);
    // The sample's place moves to the pixel's centre, where the rasteriser samples.
    vec2 shift = (0.5 - push.jitter) * 2.0 * push.pixel;
    return vec4(dot(from_eye, right) + shift.x * w, -dot(from_eye, up) + shift.y * w, push.near_plane, w);
}
