// SPDX-License-Identifier: Apache-2.0
// Light samples: a point on a light, or a direction to it.
#ifndef UTSURI_KERNELS_SCENE_LIGHTS
#define UTSURI_KERNELS_SCENE_LIGHTS

#include "interop/scene.h"
#include "lib/cosine.glsl"
#include "kernels/scene/light_choice.glsl"
#include "kernels/scene/surface.glsl"
#include "kernels/scene/triangle_sampling.glsl"

struct LightSample {
    vec3 direction;      ///< unit, from the surface to the light
    vec3 target;         ///< where the shadow ray ends, off the light's own surface; unused where `infinite`
    bool infinite;
    vec3 irradiance;     ///< of a plane across the direction, lux, over the chance of this sample
    float pdf;           ///< over solid angle, choice of the light included; 0 for lights without extent
    uint triangle;       ///< the light's, or NONE
};

LightSample sample_triangle_light(LightInfo light, float probability, Surface surface, vec2 u) {
    BvhTriangle vertices = bvh_triangle(light.triangle);
    TriangleInfo info = triangle_infos[light.triangle];
    TriangleSampling sampling = triangle_sampling(vertices, info.material, surface.position);
    vec2 b = sample_triangle(sampling, vertices, surface.position, u);
    vec3 point = triangle_point(vertices, b.x, b.y);
    vec3 area = triangle_cross(vertices);
    vec3 to_light = point - surface.position;
    LightSample s;
    s.direction = normalize_any_scale(to_light);
    s.infinite = false;
    s.triangle = light.triangle;
    float facing = dot(area, -s.direction);
    vec2 texcoord = HAS_TEXTURES ? interpolated_texcoord(info.vertices, b.x, b.y) : vec2(0.0);
    vec3 radiance = emitted_radiance(materials[info.material], texcoord, facing > 0.0);
    s.pdf = triangle_light_pdf(sampling, probability, abs(facing), to_light);
    // A plane triangle does not light itself, whatever rounding makes of points on it.
    bool shines = facing != 0.0 && s.pdf > 0.0 && light.triangle != surface.triangle;
    s.irradiance = shines ? radiance / s.pdf : vec3(0.0);
    s.target = offset_origin(point, triangle_point_error(vertices, b.x, b.y), normalize_any_scale(area), -s.direction);
    return s;
}

/// KHR_lights_punctual: inverse square law, smooth cone, and the recommended window where a range is given.
LightSample sample_punctual_light(LightInfo light, float probability, Surface surface) {
    LightSample s;
    s.triangle = NONE;
    s.pdf = 0.0;
    s.infinite = light.type == LIGHT_DIRECTIONAL;
    s.target = light.position;
    if (s.infinite) {
        s.direction = -light.direction;
        s.irradiance = light.intensity / probability;
        return s;
    }
    vec3 to_light = light.position - surface.position;
    float distance_squared = dot(to_light, to_light);
    s.direction = normalize_any_scale(to_light);
    float factor = distance_squared > 0.0 ? 1.0 / distance_squared : 0.0;
    if (!isinf(light.range)) {
        float ratio = sqrt(distance_squared) / light.range;
        factor *= clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0);
    }
    if (light.type == LIGHT_SPOT) {
        float cone = clamp(dot(light.direction, -s.direction) * light.spot_scale + light.spot_offset, 0.0, 1.0);
        factor *= cone * cone;
    }
    s.irradiance = light.intensity * (factor / probability);
    return s;
}

/// The uniform environment, by the cosine to the shading normal.
float environment_pdf(float probability, float cosine) {
    return probability * cosine / PI;
}

/// Density over solid angle with which a light sample would have found what a ray meets.
/// @param left what the ray left
float light_pdf(Hit hit, vec3 direction, Receiver left) {
    if (hit.triangle == NONE) {
        return HAS_ENVIRONMENT ? environment_pdf(choice_probability(ENVIRONMENT_LIGHT, left), dot(left.normal, direction)) : 0.0;
    }
    TriangleInfo info = triangle_infos[hit.triangle];
    if (!HAS_TRIANGLE_LIGHTS || info.light == NONE) return 0.0;
    BvhTriangle vertices = bvh_triangle(hit.triangle);
    float facing = abs(dot(triangle_cross(vertices), direction));
    TriangleSampling sampling = triangle_sampling(vertices, info.material, left.position);
    return triangle_light_pdf(sampling, choice_probability(info.light, left), facing, hit.t * direction);
}

LightSample sample_environment(LightInfo light, float probability, Surface surface, vec2 u) {
    LightSample s;
    s.direction = cosine_direction(surface.ns, u);
    s.infinite = true;
    s.triangle = NONE;
    s.target = vec3(0.0);
    s.pdf = environment_pdf(probability, sqrt(1.0 - u.x));
    s.irradiance = s.pdf > 0.0 ? light.intensity / s.pdf : vec3(0.0);
    return s;
}

/// @param choice of a light, not NONE
LightSample sample_light(LightChoice choice, Surface surface, vec2 u) {
    const bool ONLY_TRIANGLES = !HAS_PUNCTUAL_LIGHTS && !HAS_ENVIRONMENT;
    const bool ONLY_ENVIRONMENT = !HAS_PUNCTUAL_LIGHTS && !HAS_TRIANGLE_LIGHTS;
    LightInfo light = lights[choice.light];
    if (HAS_TRIANGLE_LIGHTS && (ONLY_TRIANGLES || light.type == LIGHT_TRIANGLE)) {
        return sample_triangle_light(light, choice.probability, surface, u);
    }
    if (HAS_ENVIRONMENT && (ONLY_ENVIRONMENT || light.type == LIGHT_ENVIRONMENT)) {
        return sample_environment(light, choice.probability, surface, u);
    }
    return sample_punctual_light(light, choice.probability, surface);
}

#endif
