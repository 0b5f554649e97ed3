// SPDX-License-Identifier: Apache-2.0
// Direct light at a surface by one light sample with a shadow ray. At a glossy lobe the light that has an extent is also
// met by rays of the lobe; the two share the work by the balance heuristic (Veach and Guibas 1995).
#ifndef UTSURI_KERNELS_SCENE_DIRECT_LIGHT
#define UTSURI_KERNELS_SCENE_DIRECT_LIGHT

#include "kernels/scene/lights.glsl"
#include "lib/lobes/lobes.glsl"
#include "lib/reservoir.glsl"
#include "lib/sampler.glsl"

/// All lobes with a width.
const uint WIDE_LOBES = (1u << LOBE_DIFFUSE) | (1u << LOBE_GLOSSY);

bool is_light_visible(Surface surface, LightSample s, uint excluded_instance) {
    vec3 origin = leave_surface(surface, s.direction);
    Ray ray = make_ray(origin, s.infinite ? s.direction : s.target - origin, surface.triangle, excluded_instance);
    ray.t_max = s.infinite ? INFINITY : 1.0;
    ray.excluded[1] = s.triangle;
    return !is_occluded(ray);
}

/// Light samples weighed against each other before the shadow ray; none to weigh in a scene with one light. Four take a fifth
/// longer and are no less wrong for the time: benchmarks/README.md.
const uint MOST_CANDIDATES = 2u;

/// One light sample, as if no other could have been taken, and what it brings without regard to shadows.
struct Candidate {
    LightSample light;
    vec3 value;
};

const Candidate NO_CANDIDATE = Candidate(LightSample(vec3(0.0), vec3(0.0), false, vec3(0.0), 0.0, NONE), vec3(0.0));

/// @param lobes that reflect the light: bits of WIDE_LOBES
Candidate make_candidate(Surface surface, vec3 wo, uint lobes, LightChoice chosen, vec2 u) {
    if (chosen.light == NONE) return NO_CANDIDATE;
    LightSample s = sample_light(chosen, surface, u);
    if (!is_above(surface, s.direction)) return Candidate(s, vec3(0.0));
    vec3 bsdf = (lobes & (1u << LOBE_DIFFUSE)) != 0u ? diffuse_value(surface, wo, s.direction) : vec3(0.0);
    if (HAS_GLOSSY && (lobes & (1u << LOBE_GLOSSY)) != 0u && is_glossy(surface)) {
        float weight = s.pdf > 0.0 ? s.pdf / (s.pdf + glossy_pdf(surface, wo, s.direction)) : 1.0;
        bsdf += weight * glossy_value(surface, wo, s.direction);
    }
    return Candidate(s, bsdf * s.irradiance * dot(surface.ns, s.direction));
}

/// Resampled importance sampling (Talbot, Cline and Egbert 2005): of a few candidates, stratified over the lights, one is
/// taken by its unshadowed value.
/// @returns with a value that is divided by the chance of this one; zero if no candidate brings anything
Candidate resample_lights(Surface surface, vec3 wo, uint lobes, vec2 choice, vec2 u) {
    uint count = min(LIGHT_COUNT, MOST_CANDIDATES);
    Candidate taken = NO_CANDIDATE;
    Reservoir reservoir = empty_reservoir(choice.y);
    for (uint i = 0u; i < count; ++i) {
        // Shifted by a sequence that fills the square evenly (Roberts 2018); each candidate's u stays uniform.
        vec2 shifted = fract(u + float(i) * vec2(0.754877666, 0.569840291));
        LightChoice chosen = choose_light(receiver_of(surface), (float(i) + choice.x) / float(count));
        Candidate candidate = make_candidate(surface, wo, lobes, chosen, shifted);
        if (takes(reservoir, candidate.value.x + candidate.value.y + candidate.value.z)) taken = candidate;
    }
    if (reservoir.taken > 0.0) taken.value *= reservoir.sum / (reservoir.taken * float(count));
    return taken;
}

/// Radiance towards wo from light that reaches the surface without being reflected on its way; of what a glossy lobe
/// reflects, the light sample's share.
/// @param lobes as make_candidate() has them
vec3 direct_light(Surface surface, vec3 wo, uint lobes, uint key, uint index, uint dimension, uint excluded_instance,
                  inout uint rays) {
    if (LIGHT_COUNT == 0u) return vec3(0.0);
    vec2 choice = sample_2d(key, index, dimension);
    Candidate taken = resample_lights(surface, wo, lobes, choice, sample_2d(key, index, dimension + 1u));
    if (taken.value == vec3(0.0)) return vec3(0.0);
    rays += 1u;
    return is_light_visible(surface, taken.light, excluded_instance) ? taken.value : vec3(0.0);
}

/// MIS weight of a lobe's ray for the light that it meets (balance heuristic).
/// @param left what the ray left
float mis_weight(LobeSample lobe, Receiver left, Hit hit) {
    return lobe.pdf / (lobe.pdf + light_pdf(hit, lobe.direction, left));
}

#endif
