// SPDX-License-Identifier: Apache-2.0
// A reflector that shows what its maps hold where the mirrored ray meets the distances kept beside them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/distances/probe_search.glsl"
#include "kernels/raster/map_lookup.glsl"
#include "kernels/raster/mapped_lobe.glsl"
#include "lib/lobes/mirror.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = DRAWN_PLAIN;
    vec3 radiance = drawn_light(wo, 0u, surface, state);
    if (is_mirror(surface)) {
        state = DRAWN_LOOKED_UP;
        ProbeHit hit = search_probes(drawn_ids.w, surface.position, mirror_direction(surface, wo));
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) *
                    map_radiance(hit.probe, seen_along(hit.ray, hit.interval.guess));
    }
    drawn = vec4(radiance, state);
}
