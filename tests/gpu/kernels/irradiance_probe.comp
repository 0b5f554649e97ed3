// SPDX-License-Identifier: Apache-2.0
// Irradiance from triangles in closed form.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/workgroup.h"
#include "probes.h"
#include "lib/triangle_irradiance.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ProbePush push; };

layout(scalar, binding = PROBE_QUERIES) readonly restrict buffer Queries { IrradianceQuery queries[]; };
layout(scalar, binding = PROBE_ANSWERS) writeonly restrict buffer Answers { float answers[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.count) return;
    IrradianceQuery query = queries[index];
    answers[index] = triangle_irradiance(query.q0, query.q1, query.q2, query.ng, query.ns);
}
