// SPDX-License-Identifier: Apache-2.0
// The radiance that arrives at a capture point from what looks the same from everywhere: by the rays that measure distances.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/radiance_bounds.h"
#include "interop/workgroup.h"
#include "kernels/distances/measured_hit.glsl"
#include "kernels/light/kept_light.glsl"
#include "kernels/scene/surface.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { MeasureFacePush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_RADIANCE_SAMPLES) writeonly restrict buffer RadianceSamples {
    RadianceSample radiance_samples[];
};

vec3 radiance_of(MeasuredHit found) {
    Hit hit = found.hit;
    if (hit.triangle == NONE) return HAS_ENVIRONMENT ? lights[ENVIRONMENT_LIGHT].intensity : vec3(0.0);
    Surface surface = make_surface(hit, found.direction);
    vec3 albedo = surface.base_colour * (1.0 - surface.metallic);
    vec3 kept = kept_light(hit.triangle, vec2(hit.b1, hit.b2), RAY_PLACE_ERROR, surface.front);
    return surface.emission + albedo * kept;
}

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    vec2 texel = texel_of_sample(index);
    vec3 centre = radiance_of(measured_hit(push.view, push.face, texel + 0.5));
    vec3 corner = radiance_of(measured_hit(push.view, push.face, texel));
    radiance_samples[push.first_sample + index] = RadianceSample(centre, corner);
}
