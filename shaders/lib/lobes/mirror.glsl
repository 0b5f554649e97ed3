// SPDX-License-Identifier: Apache-2.0
// The lobe of a perfect mirror or a smooth dielectric: one direction. Its value and its density are those of a delta
// function, and 0 in every direction that something else has chosen.
#ifndef UTSURI_LIB_LOBES_MIRROR
#define UTSURI_LIB_LOBES_MIRROR

#include "lib/lobes/lobe_sample.glsl"
#include "lib/reflectance.glsl"

/// The mirrored direction. Near silhouettes an interpolated normal can mirror the ray into the surface; it is mirrored
/// out again at the geometric plane, which is continuous.
vec3 mirror_direction(Surface surface, vec3 wo) {
    vec3 wi = reflect(-wo, surface.ns);
    float below = dot(wi, surface.ng);
    return below < 0.0 ? wi - 2.0 * below * surface.ng : wi;
}

LobeSample sample_mirror(Surface surface, vec3 wo) {
    return LobeSample(mirror_direction(surface, wo), specular_reflectance(surface, abs(dot(surface.ns, wo))), 0.0);
}

#endif
