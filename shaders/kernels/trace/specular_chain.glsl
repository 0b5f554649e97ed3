// SPDX-License-Identifier: Apache-2.0
// A camera ray and what it meets by way of specular lobes, followed to a depth: perfect mirrors (Whitted 1980), and rough
// lobes in one direction a sample (Cook, Porter and Carpenter 1984). Diffuse lobes end the chain.
#ifndef UTSURI_KERNELS_TRACE_SPECULAR_CHAIN
#define UTSURI_KERNELS_TRACE_SPECULAR_CHAIN
#include "interop/frame.h"
#include "kernels/scene/direct_light.glsl"
#include "lib/lobes/glossy.glsl"
#include "lib/lobes/mirror.glsl"
#include "lib/roulette.glsl"

/// What light a surface sends out, its own emission and its reflections excepted. The kernel defines it.
/// @param throughput what of it arrives at the eye: it is not worth a ray where that is next to nothing, see survival()
vec3 surface_light(Surface surface, Hit hit, vec3 wo, vec3 throughput, uint key, uint index, uint dimension,
                   uint excluded_instance, inout uint rays);

/// Chains that bring less than this share of the light they meet go on by chance: in a room of dielectrics, which reflect 4 %,
/// chains would else go on to the max depth for next to nothing. Their noise stays below the square root of what is brought on
/// average times this share, a few percent of the light met.
const float LEAST_THROUGHPUT = 1.0 / 32.0;

/// A ray and what it brings along.
struct Chain {
    Ray ray;
    uint depth;       ///< reflections that it has behind it
    vec3 throughput;  ///< of them
    bool by_lobe;     ///< whether the last one was by a glossy lobe
    LobeSample lobe;  ///< in which it chose this direction
    Receiver left;    ///< from where
};

Chain start_chain(Ray ray, uint depth) {
    return Chain(ray, depth, vec3(1.0), false, LobeSample(vec3(0.0), vec3(0.0), 0.0), Receiver(vec3(0.0), vec3(0.0)));
}

/// @param max_depth reflections after which a chain is cut
vec3 follow_chain(Chain chain, uint max_depth, uint key, uint index, inout Counters totals) {
    vec3 radiance = vec3(0.0);
    Ray ray = chain.ray;
    vec3 throughput = chain.throughput;
    bool by_lobe = chain.by_lobe;
    LobeSample lobe = chain.lobe;
    Receiver left = chain.left;
    for (uint depth = chain.depth;; ++depth) {
        totals.rays += 1u;
        Hit hit = closest_hit(ray);
        float weight = HAS_GLOSSY && by_lobe ? mis_weight(lobe, left, hit) : 1.0;
        if (hit.triangle == NONE) {
            if (HAS_ENVIRONMENT) radiance += weight * throughput * lights[ENVIRONMENT_LIGHT].intensity;
            break;
        }
        Surface surface = make_surface(hit, ray.direction);
        radiance += weight * throughput * surface.emission;
        // A glossy lobe cut at the bound still meets the lights: they are direct.
        if (HAS_GLOSSY && depth > max_depth) break;
        vec3 wo = -ray.direction;
        uint dimension = FIRST_SURFACE_DIMENSION + depth * DIMENSIONS_PER_SURFACE;
        radiance += throughput * surface_light(surface, hit, wo, throughput, key, index, dimension,
                                               ray.excluded_instance, totals.rays);
        by_lobe = HAS_GLOSSY && is_glossy(surface);
        if (!by_lobe && !(HAS_MIRROR && is_mirror(surface))) break;
        vec2 u = by_lobe ? sample_2d(key, index, dimension + 2u) : vec2(0.0);
        if (by_lobe) {
            lobe = sample_glossy(surface, wo, u);
        } else {
            lobe = sample_mirror(surface, wo);
        }
        throughput *= lobe.throughput;
        if (by_lobe) {
            if (throughput == vec3(0.0)) break;
            float chance = survival(throughput, LEAST_THROUGHPUT);
            if (sample_2d(key, index, dimension + 3u).x >= chance) break;
            throughput /= chance;
        }
        left = receiver_of(surface);
        totals.lookups += 1u;
        if (depth == max_depth) {
            totals.truncated += 1u;
            if (!by_lobe) break;
        } else {
            totals.traced += 1u;
        }
        ray = make_ray(leave_surface(surface, lobe.direction), lobe.direction, surface.triangle, ray.excluded_instance);
    }
    return radiance;
}

#endif
