// SPDX-License-Identifier: Apache-2.0
// Light that would reach a diffuse surface if nothing stood between it and the lights, in closed form.
#ifndef UTSURI_KERNELS_SCENE_UNSHADOWED_LIGHT
#define UTSURI_KERNELS_SCENE_UNSHADOWED_LIGHT

#include "kernels/scene/lights.glsl"

/// Twice the part of Lambert's contour integral (1760) along the great circle from unit vector a to b.
float contour_part(vec3 a, vec3 b, vec3 n) {
    vec3 across = cross(a, b);
    float sine = length(across);
    return sine > 0.0 ? atan(sine, dot(a, b)) * dot(across, n) / sine : 0.0;
}

/// Where the great circle from a above the horizon to b below it meets the horizon.
vec3 horizon_point(vec3 a, vec3 b, vec3 n) {
    return normalize_any_scale(a * -dot(b, n) + b * dot(a, n));
}

/// Irradiance at a point with unit normal n from a triangle of radiance 1, of which only what is above the horizon shines.
float triangle_irradiance(BvhTriangle vertices, vec3 point, vec3 n) {
    vec3 corners[3] = {normalize_any_scale(vertices.v0 - point), normalize_any_scale(vertices.v1 - point),
                       normalize_any_scale(vertices.v2 - point)};
    float sum = 0.0;
    vec3 leaves = vec3(0.0);
    vec3 returns = vec3(0.0);
    for (uint i = 0u; i < 3u; ++i) {
        vec3 a = corners[i];
        vec3 b = corners[(i + 1u) % 3u];
        bool a_above = dot(a, n) > 0.0;
        bool b_above = dot(b, n) > 0.0;
        if (a_above && !b_above) b = leaves = horizon_point(a, b, n);
        if (!a_above && b_above) a = returns = horizon_point(b, a, n);
        if (a_above || b_above) sum += contour_part(a, b, n);
    }
    // The way along the horizon, which closes the contour.
    if (leaves != vec3(0.0) && returns != vec3(0.0)) sum += contour_part(leaves, returns, n);
    return 0.5 * abs(sum);
}

/// What one light brings to a surface whose normals agree, in lux.
vec3 unshadowed_irradiance(LightInfo light, Surface surface) {
    if (HAS_TRIANGLE_LIGHTS && light.type == LIGHT_TRIANGLE) {
        BvhTriangle vertices = bvh_triangles[light.triangle];
        bool front = dot(triangle_cross(vertices), surface.position - vertices.v0) > 0.0;
        vec3 radiance = emitted_radiance(materials[triangle_infos[light.triangle].material], vec2(0.0), front);
        return radiance == vec3(0.0) ? radiance : radiance * triangle_irradiance(vertices, surface.position, surface.ng);
    }
    if (HAS_ENVIRONMENT && light.type == LIGHT_ENVIRONMENT) return PI * light.intensity;
    LightSample s = sample_punctual_light(light, light.probability, surface);
    return s.irradiance * (light.probability * max(dot(surface.ng, s.direction), 0.0));
}

vec3 unshadowed_irradiance(Surface surface) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < LIGHT_COUNT; ++i) sum += unshadowed_irradiance(lights[i], surface);
    return sum;
}

#endif
