// SPDX-License-Identifier: Apache-2.0
// The per-vertex pass of reflection mapping: for every vertex of a reflective instance, where it reflects the eye's ray.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/reflection.h"
#include "interop/workgroup.h"
#include "lib/numeric.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ReflectVerticesPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_REFLECTOR_VERTICES) readonly restrict buffer ReflectorVertices {
    ReflectorVertex reflector_vertices[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_VERTEX_REFLECTIONS) writeonly restrict buffer VertexReflections {
    VertexReflection vertex_reflections[];
};

/// Texture coordinate of OpenGL's sphere map texture generation (specification 2.1, section 2.11.4), t upwards.
vec2 sphere_map_coordinate(vec3 reflected) {
    vec3 r = normalize_any_scale(vec3(dot(reflected, push.right), dot(reflected, push.up), -dot(reflected, push.forward)));
    float m = 2.0 * sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));
    return m > 0.0 ? r.xy / m + 0.5 : vec2(0.5, 1.0);
}

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    ReflectorVertex vertex = reflector_vertices[index];
    // Not normalised: on a plane this is affine in the position, so that interpolating it is exact.
    vec3 reflected = reflect(vertex.position - push.eye, vertex.normal);
    vertex_reflections[index] = VertexReflection(reflected, sphere_map_coordinate(reflected));
}
