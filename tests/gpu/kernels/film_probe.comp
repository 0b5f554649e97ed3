// SPDX-License-Identifier: Apache-2.0
// The compensated sum of the film.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/workgroup.h"
#include "probes.h"
#include "lib/film.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ProbePush push; };

layout(scalar, binding = PROBE_QUERIES) readonly restrict buffer Queries { FilmQuery queries[]; };
layout(scalar, binding = PROBE_ANSWERS) writeonly restrict buffer Answers { FilmAnswer answers[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.count) return;
    FilmQuery query = queries[index];
    vec3 sum = vec3(0.0);
    vec3 compensation = vec3(0.0);
    for (uint i = 0u; i < query.repeats; ++i) add_compensated(sum, compensation, vec3(query.a));
    add_compensated(sum, compensation, vec3(query.b));
    add_compensated(sum, compensation, vec3(query.c));
    answers[index] = FilmAnswer(sum.x, compensation.x);
}
