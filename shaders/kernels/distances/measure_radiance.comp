// SPDX-License-Identifier: Apache-2.0
// The radiance that arrives at a capture point from what looks the same from everywhere: two rays a texel, the same as
// measure_distances.comp sends.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/radiance_bounds.h"
#include "interop/workgroup.h"
#include "kernels/light/kept_light.glsl"
#include "kernels/scene/surface.glsl"
#include "lib/cube.glsl"
#include "lib/distance_constants.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { MeasureRadiancePush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_RADIANCE_SAMPLES) writeonly restrict buffer RadianceSamples {
    RadianceSample radiance_samples[];
};

/// @param place in texels from the face's corner of least coordinates
vec3 measure(vec2 place) {
    vec2 p = place * (2.0 / float(DISTANCE_SIZE)) - 1.0;
    vec3 direction = cube_vector(vec3(p, 1.0), push.face);
    Hit hit = closest_hit(make_ray(push.capture_point, direction, NONE, push.excluded_instance));
    if (hit.triangle == NONE) return HAS_ENVIRONMENT ? lights[ENVIRONMENT_LIGHT].intensity : vec3(0.0);
    Surface surface = make_surface(hit, direction);
    vec3 albedo = surface.base_colour * (1.0 - surface.metallic);
    return surface.emission + albedo * kept_light(light_record(hit.triangle), vec2(hit.b1, hit.b2), surface.front);
}

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    vec2 texel = vec2(index % DISTANCE_STRIDE, index / DISTANCE_STRIDE) - float(DISTANCE_BORDER);
    radiance_samples[index] = RadianceSample(measure(texel + 0.5), measure(texel));
}
