// SPDX-License-Identifier: Apache-2.0
// Trigonometry, normalisation, bases and neighbouring floats.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/workgroup.h"
#include "probes.h"
#include "lib/basis.glsl"
#include "lib/numeric.glsl"
#include "lib/trigonometry.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ProbePush push; };

layout(scalar, binding = PROBE_QUERIES) readonly restrict buffer Queries { NumericQuery queries[]; };
layout(scalar, binding = PROBE_ANSWERS) writeonly restrict buffer Answers { NumericAnswer answers[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.count) return;
    NumericQuery query = queries[index];
    NumericAnswer answer;
    answer.cos_sin = cos_sin_of_turn(query.turn);
    answer.normalized = normalize_any_scale(query.vector);
    make_basis(query.normal, answer.tangent, answer.bitangent);
    answer.next = vec3(next_float_towards(query.vector.x, query.normal.x),
                       next_float_towards(query.vector.y, query.normal.y),
                       next_float_towards(query.vector.z, query.normal.z));
    answers[index] = answer;
}
