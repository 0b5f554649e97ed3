// SPDX-License-Identifier: Apache-2.0
// The GGX lobe.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/workgroup.h"
#include "probes.h"
#include "lib/microfacet.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ProbePush push; };

layout(scalar, binding = PROBE_QUERIES) readonly restrict buffer Queries { MicrofacetQuery queries[]; };
layout(scalar, binding = PROBE_ANSWERS) writeonly restrict buffer Answers { MicrofacetAnswer answers[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.count) return;
    MicrofacetQuery query = queries[index];
    vec3 h = normalize(query.wo + query.wi);
    float cos_o = dot(query.normal, query.wo);
    float cos_i = dot(query.normal, query.wi);
    float d = ggx_distribution(query.normal, h, query.alpha);
    answers[index] = MicrofacetAnswer(d, d * smith_visibility(cos_o, cos_i, query.alpha),
                                      ggx_pdf(query.normal, h, cos_o, query.alpha),
                                      sample_ggx_normal(query.normal, query.wo, query.alpha, query.u));
}
