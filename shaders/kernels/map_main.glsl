// SPDX-License-Identifier: Apache-2.0
// Direct light as in direct/trace, with the light along a specular direction found in a map. The including kernel
// defines before: vec3 reflected_radiance(Surface surface, Hit hit, vec3 wi);

vec3 sample_radiance(vec3 origin, vec3 direction, uint key, uint index, inout Counters totals) {
    totals.rays += 1u;
    Hit hit = closest_hit(make_ray(origin, direction, NONE, NONE));
    if (hit.triangle == NONE) return HAS_ENVIRONMENT ? lights[ENVIRONMENT_LIGHT].intensity : vec3(0.0);
    Surface surface = make_surface(hit, direction);
    vec3 radiance = surface.emission + direct_light(surface, -direction, key, index, FIRST_SURFACE_DIMENSION, NONE, totals.rays);
    if (HAS_SPECULAR && is_specular(surface)) {
        totals.lookups += 1u;
        radiance += specular_reflectance(surface, abs(dot(surface.ns, direction))) *
                    reflected_radiance(surface, hit, mirror_direction(surface, -direction));
    }
    return radiance;
}
