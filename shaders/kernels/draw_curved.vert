// SPDX-License-Identifier: Apache-2.0
// The corners of listed triangles that reflect like curved mirrors, with the maps they look up.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "lib/surface.glsl"
#include "kernels/drawn_list.glsl"
#include "kernels/drawn_triangle.glsl"
#include "kernels/drawn_vertex.glsl"

layout(scalar, binding = BINDING_LISTED_REFLECTORS) readonly restrict buffer ListedReflectors {
    uint listed_reflectors[];
};

void main() {
    uint corner = uint(gl_VertexIndex) % 3u;
    set_drawn_triangle(listed_triangle(), vec2(corner == 1u, corner == 2u));
    drawn_ids.w = listed_reflectors[uint(gl_VertexIndex) / 3u];
    drawn_from_eye = listed_corner() - push.camera.origin;
    gl_Position = project(drawn_from_eye);
}
