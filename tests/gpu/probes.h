// SPDX-License-Identifier: Apache-2.0
// What the probe kernels of this folder are asked and answer, for C++ and GLSL.
#ifndef UTSURI_TESTS_GPU_PROBES_H
#define UTSURI_TESTS_GPU_PROBES_H
#include "interop/prelude.h"
INTEROP_BEGIN

INTEROP_CONSTANT PROBE_QUERIES = 0u;  ///< binding
INTEROP_CONSTANT PROBE_ANSWERS = 1u;  ///< binding

struct ProbePush {
    uint count;
};

struct SamplerQuery {
    uvec2 pixel;
    uint seed;
    uint estimate;
    uint index;
    uint dimension_pair;
};

struct SamplerAnswer {
    uint key;
    uint scrambled;  ///< owen_scramble(index, seed)
    uvec2 sobol;     ///< point `index`
    vec2 point;
};

struct NumericQuery {
    vec3 vector;  ///< any length
    vec3 normal;  ///< unit
    float turn;   ///< [0, 1]
};

struct NumericAnswer {
    vec2 cos_sin;
    vec3 normalized;
    vec3 tangent;  ///< of the basis about `normal`
    vec3 bitangent;
    vec3 next;  ///< each component of `vector` moved by one float towards the sign of that of `normal`
};

struct MicrofacetQuery {
    vec3 normal;
    vec3 wo;
    vec3 wi;
    float alpha;
    vec2 u;
};

struct MicrofacetAnswer {
    float distribution;  ///< at the half vector of wo and wi
    float brdf;          ///< with a Fresnel reflectance of 1
    float pdf;           ///< of wi, over solid angle
    vec3 sampled_normal;
};

/// A triangle as seen from the origin, and the normals of the surface there.
struct IrradianceQuery {
    vec3 q0;
    vec3 q1;
    vec3 q2;
    vec3 ng;
    vec3 ns;
};

/// Sums `repeats` times a, then b, then c, by the film's compensated sum.
struct FilmQuery {
    float a;
    float b;
    float c;
    uint repeats;
};

struct FilmAnswer {
    float sum;
    float compensation;
};

INTEROP_END
#endif
