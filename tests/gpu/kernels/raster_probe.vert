// SPDX-License-Identifier: Apache-2.0
// Triangles given in clip space.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(push_constant, scalar) uniform Push { float shift; };
layout(scalar, binding = 0) readonly restrict buffer Corners { vec4 corners[]; };

layout(location = 0) out vec2 position;
layout(location = 1) flat out uint triangle;

void main() {
    gl_Position = corners[gl_VertexIndex] + vec4(shift, 0.0, 0.0, 0.0);
    position = corners[gl_VertexIndex].xy / corners[gl_VertexIndex].w;
    triangle = uint(gl_VertexIndex) / 3u;
}
