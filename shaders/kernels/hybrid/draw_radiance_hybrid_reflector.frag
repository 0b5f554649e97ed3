// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where that is as bright as it should be, give or take the tolerance, and
// traced elsewhere. Looked up is only what the capture point sees and what looks the same from there: the radiance of what
// the ray meets is then among what arrives from where that can lie.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/distances/radiance_bounds.glsl"
#include "kernels/hybrid/drawn_prediction.glsl"
#include "kernels/hybrid/hybrid_reflector.glsl"

bool look_up(Surface surface, vec3 wo, out vec3 radiance) {
    DrawnReflection reflection = drawn_reflection_of(surface, wo);
    SearchRay ray = reflection.ray;
    HitInterval interval = reflection.interval;
    if (!is_bounded(interval)) return false;
    radiance = map_radiance(reflection.probe, seen_along(ray, interval.guess));
    RadianceBounds truth =
        bounds_along(distance_maps[reflection.probe].first_bounds, seen_along(ray, interval.t0), seen_along(ray, interval.t1));
    return relative_error(radiance, truth) <= frame.tolerance;
}

void main() {
    draw_hybrid_reflector();
}
