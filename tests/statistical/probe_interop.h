// SPDX-License-Identifier: Apache-2.0
// What kernels/sampler_probe.comp is told and tells.
#ifndef UTSURI_STATISTICAL_PROBE_INTEROP_H
#define UTSURI_STATISTICAL_PROBE_INTEROP_H
#include "interop/prelude.h"
#include "interop/specialization.h"
INTEROP_BEGIN

/// Which sampling function is called; the value of PROBE_SPEC_SAMPLER.
INTEROP_CONSTANT PROBE_GLOSSY = 0u;        ///< sample_glossy() and glossy_pdf()
INTEROP_CONSTANT PROBE_LIGHT = 1u;         ///< sample_light() of the first light
INTEROP_CONSTANT PROBE_LIGHT_CHOICE = 2u;  ///< choose_light()
INTEROP_CONSTANT PROBE_LOBE = 3u;          ///< sample_lobe(), lobe_value() and lobe_pdf() of ProbePush::lobe
INTEROP_CONSTANT PROBE_SURFACE = 4u;       ///< make_surface() on triangle 0, seen along -wo

INTEROP_CONSTANT PROBE_SPEC_SAMPLER = SPEC_COUNT;

/// Bindings beyond those of the scene.
INTEROP_CONSTANT PROBE_BINDING_INPUTS = 30u;
INTEROP_CONSTANT PROBE_BINDING_OUTPUTS = 31u;

struct ProbePush {
    vec3 position;  ///< of the surface, scene space
    vec3 normal;    ///< unit
    vec3 wo;        ///< unit
    float alpha;
    uint lobe;  ///< LOBE_ of lib/lobes/lobes.glsl
    uint count;
};

struct ProbeOutput {
    vec3 direction;
    float pdf;    ///< of a surface: its eta; of a choice: its probability
    vec3 target;  ///< on the light; of a lobe: its value times the cosine
    uint light;   ///< of a surface: 1 if its front is seen
    vec3 weight;  ///< of a lobe: what its sample's throughput says that value is; of a choice, in x:
                  ///< choice_probability()
};

INTEROP_END
#endif
