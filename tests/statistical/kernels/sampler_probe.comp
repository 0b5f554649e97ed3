// SPDX-License-Identifier: Apache-2.0
// Calls a sampling function for given numbers in [0, 1)^2 and tells what it returns.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/workgroup.h"
#include "kernels/scene/lights.glsl"
#include "lib/lobes/lobes.glsl"
#include "probe_interop.h"

layout(local_size_x = WORKGROUP_SIZE) in;
layout(constant_id = PROBE_SPEC_SAMPLER) const uint SAMPLER = PROBE_GLOSSY;
layout(push_constant, scalar) uniform Push { ProbePush push; };
layout(scalar, binding = PROBE_BINDING_INPUTS) readonly restrict buffer Inputs { vec2 inputs[]; };
layout(scalar, binding = PROBE_BINDING_OUTPUTS) writeonly restrict buffer Outputs { ProbeOutput outputs[]; };

Surface probed_surface() {
    Surface surface;
    surface.position = push.position;
    surface.error_bound = vec3(0.0);
    surface.ng = push.normal;
    surface.ns = push.normal;
    surface.texcoord = vec2(0.0);
    surface.triangle = NONE;
    surface.material = 0u;
    surface.instance = 0u;
    surface.front = true;
    surface.eta = 1.5;
    surface.base_colour = vec3(1.0);
    surface.metallic = 1.0;
    surface.alpha = push.alpha;
    surface.f0 = vec3(0.0);
    surface.f90 = 0.0;
    surface.emission = vec3(0.0);
    return surface;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.count) return;
    vec2 u = inputs[index];
    ProbeOutput result = ProbeOutput(vec3(0.0), 0.0, vec3(0.0), 0u, vec3(0.0));
    Surface surface = probed_surface();
    if (SAMPLER == PROBE_GLOSSY) {
        result.direction = glossy_direction(surface, push.wo, u);
        result.pdf = glossy_pdf(surface, push.wo, result.direction);
    } else if (SAMPLER == PROBE_LIGHT) {
        LightSample light_sample = sample_light(LightChoice(0u, choice_probability(0u, receiver_of(surface))), surface, u);
        result.direction = light_sample.direction;
        result.pdf = light_sample.pdf;
        result.target = light_sample.target;
    } else if (SAMPLER == PROBE_LOBE) {
        surface.base_colour = vec3(0.9, 0.5, 0.2);
        surface.metallic = 0.25;
        surface.f0 = vec3(0.04);
        surface.f90 = 1.0;
        LobeSample lobe = sample_lobe(surface, push.lobe, push.wo, u);
        result.direction = lobe.direction;
        if (lobe.pdf > 0.0) {
            result.pdf = lobe_pdf(surface, push.lobe, push.wo, lobe.direction);
            result.target = lobe_value(surface, push.lobe, push.wo, lobe.direction) * dot(surface.ns, lobe.direction);
            result.weight = lobe.throughput * lobe.pdf;
        }
    } else if (SAMPLER == PROBE_SURFACE) {
        Surface seen = make_surface(Hit(1.0, 0u, 0.25, 0.25), -push.wo);
        result.light = seen.front ? 1u : 0u;
        result.pdf = seen.eta;
        result.direction = seen.ng;
    } else {
        LightChoice choice = choose_light(receiver_of(surface), u.x);
        result.light = choice.light;
        result.pdf = choice.probability;
        result.weight.x = choice.light == NONE ? 0.0 : choice_probability(choice.light, receiver_of(surface));
    }
    outputs[index] = result;
}
