// SPDX-License-Identifier: Apache-2.0
// Where drawn points land in the picture.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_PROJECTION
#define UTSURI_KERNELS_RASTER_DRAWN_PROJECTION

#include "kernels/raster/view.glsl"
#include "kernels/scene/layers.glsl"

// Passes over the same triangles must agree on their depth to the bit.
invariant gl_Position;

/// Depth by which a triangle is moved back for each that lies on it in its plane: by how much rounding may put it in front.
/// @param w of a point of it, along the viewing direction
float depth_behind_layers(uint triangle, float w) {
    /// Corners move to the nearest 1/256 of a pixel, those of either triangle.
    const float SNAPPED = 1.0 / 256.0;  // of a pixel
    /// Depth is interpolated with some roundings of the largest, which may lie outside the picture.
    const float DEPTH_ROUNDING = 1.0 / 262144.0;
    /// Vertices and plane are each known to the distance of layers.
    const float DISTANCES = 4.0;
    BvhTriangle vertices = bvh_triangle(triangle);
    vec3 normal = triangle_normal(vertices);
    float least_distance = DISTANCES * layer_distance();
    float distance = max(abs(dot(normal, vertices.v0 - view.camera.origin)), least_distance);
    // In the plane 1 / w is the normal times the direction to a pixel, over the distance: at most so much in the picture.
    vec3 along = abs(vec3(dot(normal, view.camera.right), dot(normal, view.camera.up), dot(normal, view.camera.forward))) / distance;
    float largest = along.x + along.y + along.z;
    float slope = 2.0 * dot(frame.pixel_size, along.xy);  // of a pixel
    float pushed = least_distance / distance + w * (SNAPPED * slope + DEPTH_ROUNDING * largest);
    return float(triangle_infos[triangle].layers) * pushed * frame.near_plane;
}

/// Perspective with the far plane at infinity and depth reversed, so that float32 depth is as fine far as near.
/// @param triangle of the scene, on which the point lies
vec4 project(vec3 from_eye, uint triangle) {
    vec3 right = view.camera.right / dot(view.camera.right, view.camera.right);
    vec3 up = view.camera.up / dot(view.camera.up, view.camera.up);
    float w = dot(from_eye, view.camera.forward);
    // The sample's place moves to the pixel's centre, where the rasteriser samples.
    vec2 shift = (0.5 - frame.jitter) * 2.0 * frame.pixel_size;
    float depth = frame.near_plane;
    if (HAS_LAYERS && triangle_infos[triangle].layers > 0u) depth -= depth_behind_layers(triangle, w);
    return vec4(dot(from_eye, right) + shift.x * w, -dot(from_eye, up) + shift.y * w, depth, w);
}

#endif
