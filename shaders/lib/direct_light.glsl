// SPDX-License-Identifier: Apache-2.0
// Direct light at a surface: one light sample with a shadow ray, and where the surface is glossy one sample of its
// lobe; the two share the work by the balance heuristic (Veach and Guibas 1995).
#ifndef UTSURI_LIB_DIRECT_LIGHT
#define UTSURI_LIB_DIRECT_LIGHT

#include "lib/bsdf.glsl"
#include "lib/lights.glsl"
#include "lib/sampler.glsl"

/// Pairs of sample dimensions that one surface uses.
const uint DIMENSIONS_PER_SURFACE = 3u;

bool is_light_visible(Surface surface, LightSample s, uint excluded_instance) {
    vec3 origin = leave_surface(surface, s.direction);
    Ray ray = make_ray(origin, s.infinite ? s.direction : s.target - origin, surface.triangle, excluded_instance);
    ray.t_max = s.infinite ? INFINITY : 1.0;
    ray.excluded[1] = s.triangle;
    return !is_occluded(ray);
}

/// Light samples weighed against each other before the shadow ray; none to weigh in a scene with one light.
const uint MOST_CANDIDATES = 4u;

/// One light sample, as if no other could have been taken, and what it brings without regard to shadows.
struct Candidate {
    LightSample light;
    vec3 value;
};

Candidate make_candidate(Surface surface, vec3 wo, float choice, vec2 u) {
    LightSample s = sample_light(choose_light(choice), surface, u);
    vec3 value = evaluate_bsdf(surface, wo, s.direction) * s.irradiance * max(dot(surface.ns, s.direction), 0.0);
    if (HAS_GLOSSY && s.pdf > 0.0 && is_glossy(surface) && value != vec3(0.0)) {
        value *= s.pdf / (s.pdf + glossy_pdf(surface, wo, s.direction));
    }
    return Candidate(s, value);
}

/// Resampled importance sampling (Talbot, Cline and Egbert 2005): of a few candidates, stratified over the light table,
/// one is taken by its unshadowed value, so that near and facing lights are not left to chance.
/// @returns with a value that is divided by the chance of this one; zero if no candidate brings anything
Candidate resample_lights(Surface surface, vec3 wo, vec2 choice, vec2 u) {
    uint count = min(LIGHT_COUNT, MOST_CANDIDATES);
    Candidate taken = Candidate(LightSample(vec3(0.0), vec3(0.0), false, vec3(0.0), 0.0, NONE), vec3(0.0));
    float taken_weight = 0.0;
    float sum = 0.0;
    float remaining = choice.y;
    for (uint i = 0u; i < count; ++i) {
        // Shifted by a sequence that fills the square evenly (Roberts 2018); each candidate's u stays uniform.
        vec2 shifted = fract(u + float(i) * vec2(0.754877666, 0.569840291));
        Candidate candidate = make_candidate(surface, wo, (float(i) + choice.x) / float(count), shifted);
        float weight = candidate.value.x + candidate.value.y + candidate.value.z;
        if (!(weight > 0.0)) continue;
        sum += weight;
        float probability = weight / sum;
        if (remaining < probability) {
            taken = candidate;
            taken_weight = weight;
            remaining /= probability;
        } else {
            remaining = (remaining - probability) / (1.0 - probability);
        }
    }
    if (taken_weight == 0.0) return taken;
    taken.value *= sum / (taken_weight * float(count));
    return taken;
}

vec3 light_by_light_sample(Surface surface, vec3 wo, vec2 choice, vec2 u, uint excluded_instance, inout uint rays) {
    Candidate taken = resample_lights(surface, wo, choice, u);
    if (taken.value == vec3(0.0)) return vec3(0.0);
    rays += 1u;
    return is_light_visible(surface, taken.light, excluded_instance) ? taken.value : vec3(0.0);
}

vec3 light_by_glossy_sample(Surface surface, vec3 wo, vec2 u, uint excluded_instance, inout uint rays) {
    vec3 wi = sample_glossy(surface, wo, u);
    vec3 value = evaluate_bsdf(surface, wo, wi) * dot(surface.ns, wi);
    if (value == vec3(0.0)) return value;
    rays += 1u;
    Hit hit = closest_hit(make_ray(leave_surface(surface, wi), wi, surface.triangle, excluded_instance));
    float light_pdf = 0.0;
    vec3 radiance = vec3(0.0);
    if (hit.triangle != NONE) {
        uint light = triangle_infos[hit.triangle].light;
        if (!HAS_TRIANGLE_LIGHTS || light == NONE) return vec3(0.0);
        BvhTriangle vertices = bvh_triangles[hit.triangle];
        TriangleInfo info = triangle_infos[hit.triangle];
        float facing = dot(triangle_cross(vertices), -wi);
        vec2 texcoord = HAS_TEXTURES ? interpolated_texcoord(info.vertices, hit.b1, hit.b2) : vec2(0.0);
        radiance = emitted_radiance(materials[info.material], texcoord, facing > 0.0);
        light_pdf = triangle_light_pdf(lights[light].probability, abs(facing), hit.t * hit.t);
    } else if (HAS_ENVIRONMENT) {
        LightInfo light = lights[ENVIRONMENT_LIGHT];
        radiance = light.intensity;
        light_pdf = environment_pdf(light.probability, dot(surface.ns, wi));
    }
    float pdf = glossy_pdf(surface, wo, wi);
    return value * radiance / (pdf + light_pdf);
}

/// Radiance towards wo from light that reaches the surface without being reflected on its way.
vec3 direct_light(Surface surface, vec3 wo, uint key, uint index, uint dimension, uint excluded_instance,
                  inout uint rays) {
    if (LIGHT_COUNT == 0u) return vec3(0.0);
    vec2 choice = sample_2d(key, index, dimension);
    vec2 u = sample_2d(key, index, dimension + 1u);
    vec3 radiance = light_by_light_sample(surface, wo, choice, u, excluded_instance, rays);
    if (HAS_GLOSSY && is_glossy(surface)) {
        vec2 lobe = sample_2d(key, index, dimension + 2u);
        radiance += light_by_glossy_sample(surface, wo, lobe, excluded_instance, rays);
    }
    return radiance;
}

#endif
