// SPDX-License-Identifier: Apache-2.0
// The corners of the scene's triangles, with what the per-vertex pass found for reflective ones.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/raster.h"
#include "interop/reflection.h"

layout(constant_id = SPEC_MAP_KIND) const uint MAP_KIND = MAP_KIND_POLYGON;

layout(push_constant, scalar) uniform Push { RasterPush push; };

layout(scalar, binding = BINDING_VERTEX_SLOTS) readonly restrict buffer VertexSlots { uint vertex_slots[]; };
layout(scalar, binding = BINDING_VERTEX_REFLECTIONS) readonly restrict buffer VertexReflections {
    VertexReflection vertex_reflections[];
};

layout(location = 0) out vec2 barycentric;
layout(location = 1) out vec3 reflection;
layout(location = 2) flat out uint triangle;

/// Perspective with the far plane at infinity and depth reversed, so that float32 depth is as fine far as near.
vec4 project(vec3 position) {
    vec3 p = position - push.camera.origin;
    vec3 right = push.camera.right / dot(push.camera.right, push.camera.right);
    vec3 up = push.camera.up / dot(push.camera.up, push.camera.up);
    float w = dot(p, push.camera.forward);
    // The sample's place moves to the pixel's centre, where the rasteriser samples.
    vec2 shift = (0.5 - push.jitter) * 2.0 * push.pixel;
    return vec4(dot(p, right) + shift.x * w, -dot(p, up) + shift.y * w, push.near_plane, w);
}

void main() {
    triangle = uint(gl_VertexIndex) / 3u;
    uint corner = uint(gl_VertexIndex) % 3u;
    BvhTriangle vertices = bvh_triangles[triangle];
    gl_Position = project(corner == 0u ? vertices.v0 : (corner == 1u ? vertices.v1 : vertices.v2));
    barycentric = vec2(corner == 1u, corner == 2u);
    reflection = vec3(0.0);
    if (HAS_SPECULAR) {
        uint slot = vertex_slots[triangle_infos[triangle].vertices[corner]];
        if (slot != NONE) {
            VertexReflection found = vertex_reflections[slot];
            reflection = MAP_KIND == MAP_KIND_SPHERE ? vec3(found.sphere_map, 0.0) : found.direction;
        }
    }
}
