// SPDX-License-Identifier: Apache-2.0
// How far what surrounds a reflector is from its capture point: two rays a texel.
#version 460
#extension GL_GOOGLE_include_directive : require
#define DISTANCE_SAMPLES_ACCESS writeonly
#include "interop/workgroup.h"
#include "kernels/distances/distance_samples.glsl"
#include "kernels/scene/surface.glsl"
#include "lib/reflectance.glsl"
#include "lib/cube.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_MARKS_GLOSSY) const bool MARKS_GLOSSY = false;

layout(push_constant, scalar) uniform Push { MeasureDistancesPush push; };

/// What a ray from the capture point meets, as DistanceSample has it.
/// @param direction unit
float distance_along(vec3 direction) {
    Hit hit = closest_hit(make_ray(push.capture_point, direction, NONE, push.excluded_instance));
    if (hit.triangle == NONE) return INFINITY;
    vec3 point = push.capture_point + hit.t * direction;
    bool is_plane = push.plane_normal != vec3(0.0);
    if (is_plane && dot(push.plane_normal, point) <= push.plane_distance) return 0.0;
    Surface surface = make_surface(hit, direction);
    // A mirror shows things at places of their own. A glossy lobe shows its surface in its place, but not as bright.
    return is_mirror(surface) || (MARKS_GLOSSY && is_glossy(surface)) ? -hit.t : hit.t;
}

/// A direction just behind the plane of a plane mirror that holds the capture point, lifted to just before it; any other is
/// returned as it is. Frames stand out from mirrors by so little that no other ray would meet them.
vec3 lifted_to_plane(vec3 direction) {
    const float BEHIND = 3.0 / float(DISTANCE_SIZE);    // a texel's diagonal, in radians, at most
    const float BEFORE = 0.0625 / float(DISTANCE_SIZE);  // 1/32 of a texel
    float elevation = dot(push.plane_normal, direction);
    return abs(elevation) < BEHIND ? normalize(direction + (BEFORE - elevation) * push.plane_normal) : direction;
}

/// @param place in texels from the face's corner of least coordinates
float measure(vec2 place) {
    vec2 p = place * (2.0 / float(DISTANCE_SIZE)) - 1.0;
    vec3 direction = normalize(cube_vector(vec3(p, 1.0), push.face));
    float found = distance_along(direction);
    return found == 0.0 ? distance_along(lifted_to_plane(direction)) : found;
}

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    vec2 texel = vec2(index % DISTANCE_STRIDE, index / DISTANCE_STRIDE) - float(DISTANCE_BORDER);
    distance_samples[push.first_sample + index] = DistanceSample(measure(texel + 0.5), measure(texel), 0.0);
}
