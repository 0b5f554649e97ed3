// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where what they show is predicted to be less pixels off its place than
// the tolerance, and traced elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/frame.h"
#include "kernels/view_push.glsl"
#include "kernels/drawn_light.glsl"
#include "kernels/map_lookup.glsl"
#include "kernels/search_bindings.glsl"
#include "kernels/drawn_prediction.glsl"

bool look_up(Surface surface, vec3 wo, out vec3 radiance) {
    DrawnReflection reflection;
    if (!find_within_tolerance(surface, wo, reflection)) return false;
    radiance = polygon_map(reflection.probe, seen_along(reflection.ray, reflection.interval.guess));
    return true;
}

#include "kernels/hybrid_reflector.glsl"
