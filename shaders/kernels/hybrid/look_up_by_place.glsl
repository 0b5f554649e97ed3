// SPDX-License-Identifier: Apache-2.0
// Right enough is what is predicted to be less pixels off its place than the tolerance.
#ifndef UTSURI_KERNELS_HYBRID_LOOK_UP_BY_PLACE
#define UTSURI_KERNELS_HYBRID_LOOK_UP_BY_PLACE

#include "kernels/hybrid/drawn_prediction.glsl"
#include "kernels/hybrid/hybrid_light.glsl"

bool look_up(Surface surface, vec3 wo, out vec3 radiance) {
    DrawnReflection reflection;
    if (!find_within_tolerance(surface, wo, reflection)) return false;
    radiance = map_radiance(reflection.probe, seen_along(reflection.ray, reflection.interval.guess));
    return true;
}

#endif
