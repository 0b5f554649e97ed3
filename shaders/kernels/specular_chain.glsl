// SPDX-License-Identifier: Apache-2.0
// A camera ray and what it meets by way of perfect mirrors, followed to a depth (Whitted 1980). The including kernel
// defines before what light a surface sends out, its own emission and its mirror image excepted:
//   vec3 surface_light(Surface surface, Hit hit, vec3 wo, uint key, uint index, uint dimension, inout uint rays);

vec3 sample_radiance(vec3 origin, vec3 direction, uint key, uint index, inout Counters totals) {
    vec3 radiance = vec3(0.0);
    vec3 throughput = vec3(1.0);
    Ray ray = make_ray(origin, direction, NONE, push.excluded_instance);
    for (uint depth = 0u;; ++depth) {
        totals.rays += 1u;
        Hit hit = closest_hit(ray);
        if (hit.triangle == NONE) {
            if (HAS_ENVIRONMENT) radiance += throughput * lights[ENVIRONMENT_LIGHT].intensity;
            break;
        }
        Surface surface = make_surface(hit, ray.direction);
        vec3 wo = -ray.direction;
        uint dimension = FIRST_SURFACE_DIMENSION + depth * DIMENSIONS_PER_SURFACE;
        radiance += throughput * surface.emission;
        radiance += throughput * surface_light(surface, hit, wo, key, index, dimension, totals.rays);
        if (!HAS_SPECULAR || !is_specular(surface)) break;
        totals.lookups += 1u;
        if (depth == push.specular_depth) {
            totals.truncated += 1u;
            break;
        }
        totals.traced += 1u;
        throughput *= specular_reflectance(surface, abs(dot(surface.ns, wo)));
        vec3 wi = mirror_direction(surface, wo);
        ray = make_ray(leave_surface(surface, wi), wi, surface.triangle, push.excluded_instance);
    }
    return radiance;
}
