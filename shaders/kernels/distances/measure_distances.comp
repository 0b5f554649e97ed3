// SPDX-License-Identifier: Apache-2.0
// How far what surrounds a reflector is from its capture point: two rays a texel.
#version 460
#extension GL_GOOGLE_include_directive : require
#define DISTANCE_SAMPLES_ACCESS writeonly
#include "interop/workgroup.h"
#include "kernels/distances/distance_samples.glsl"
#include "kernels/distances/measured_hit.glsl"
#include "kernels/scene/surface.glsl"
#include "lib/reflectance.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_MARKS_GLOSSY) const bool MARKS_GLOSSY = false;

layout(push_constant, scalar) uniform Push { MeasureFacePush push; };

/// As DistanceSample has it.
float distance_of(MeasuredHit found) {
    if (found.hit.triangle == NONE) return INFINITY;
    if (found.is_behind) return 0.0;
    Surface surface = make_surface(found.hit, found.direction);
    // A mirror shows things at places of their own. A glossy lobe shows its surface in its place, but not as bright.
    return is_mirror(surface) || (MARKS_GLOSSY && is_glossy(surface)) ? -found.hit.t : found.hit.t;
}

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    vec2 texel = texel_of_sample(index);
    float centre = distance_of(measured_hit(push.view, push.face, texel + 0.5));
    float corner = distance_of(measured_hit(push.view, push.face, texel));
    distance_samples[push.first_sample + index] = DistanceSample(centre, corner, 0.0);
}
