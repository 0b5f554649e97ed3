// SPDX-License-Identifier: Apache-2.0
// The sampler, which src/base/sampler.h must equal bit for bit.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/workgroup.h"
#include "probes.h"
#include "lib/sampler.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ProbePush push; };

layout(scalar, binding = PROBE_QUERIES) readonly restrict buffer Queries { SamplerQuery queries[]; };
layout(scalar, binding = PROBE_ANSWERS) writeonly restrict buffer Answers { SamplerAnswer answers[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.count) return;
    SamplerQuery query = queries[index];
    uint key = sampler_key(query.pixel, query.seed, query.estimate);
    answers[index] = SamplerAnswer(key, owen_scramble(query.index, query.seed), sobol_2d(query.index),
                                   sample_2d(key, query.index, query.dimension_pair));
}
