// SPDX-License-Identifier: Apache-2.0
// Light of all lights at a point, shadows apart.
#ifndef UTSURI_KERNELS_LIGHT_LIGHT_SUMS
#define UTSURI_KERNELS_LIGHT_LIGHT_SUMS

#include "interop/light_mesh.h"
#include "interop/light_sums.h"
#include "kernels/light/unshadowed_light.glsl"

layout(set = METHOD_SET, binding = BINDING_SUMMED_LIGHTS) uniform usamplerBuffer summed_lights;
layout(push_constant, scalar) uniform Push { LightPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_GROUPS) readonly restrict buffer LightGroups { LightGroup light_groups[]; };

/// What each group brings to the point that was summed last, lux.
vec3 group_irradiance[MOST_LIGHT_GROUPS];

const int TEXELS_PER_LIGHT = 6;

/// Without its vertices and what follows them: triangle_of(), light_of(), first_piece_of().
SummedLight summed_light(uint index) {
    int texel = TEXELS_PER_LIGHT * int(index);
    uvec4 a = texelFetch(summed_lights, texel);
    uvec4 b = texelFetch(summed_lights, texel + 1);
    uvec4 c = texelFetch(summed_lights, texel + 2);
    SummedLight light;
    light.middle = uintBitsToFloat(a.xyz);
    light.size_squared = uintBitsToFloat(a.w);
    light.area = uintBitsToFloat(b.xyz);
    light.group = b.w;
    light.radiance = uintBitsToFloat(c.xyz);
    light.is_double_sided = c.w;
    return light;
}

BvhTriangle triangle_of(uint index) {
    int texel = TEXELS_PER_LIGHT * int(index) + 3;
    return BvhTriangle(uintBitsToFloat(texelFetch(summed_lights, texel).xyz),
                       uintBitsToFloat(texelFetch(summed_lights, texel + 1).xyz),
                       uintBitsToFloat(texelFetch(summed_lights, texel + 2).xyz));
}

uint light_of(uint index) {
    return texelFetch(summed_lights, TEXELS_PER_LIGHT * int(index) + 3).w;
}

uint first_piece_of(uint index) {
    return texelFetch(summed_lights, TEXELS_PER_LIGHT * int(index) + 4).w;
}

/// Whether a triangle shows its bright side, and some of it may be above both horizons: no point of it is farther from its
/// middle than two thirds of its longest edge. A point in its plane, as well as rounding tells, sees it edge-on: were it a
/// rounding above the triangle that it lies on, half of its sky would shine.
bool may_shine(SummedLight light, Surface surface) {
    const float PLANE_ROUNDINGS = 8.0;  // of the middle, and of corners that make the plane
    vec3 way = light.middle - surface.position;
    float reach = 0.667 * sqrt(light.size_squared);
    float height = -dot(light.area, way);
    vec3 rounded = surface.error_bound + rounding_bound(PLANE_ROUNDINGS) * (abs(light.middle) + abs(surface.position));
    return (light.is_double_sided == 1u ? abs(height) : height) > dot(abs(light.area), rounded) &&
           dot(way, surface.ns) > -reach && dot(way, surface.ng) > -reach;
}

bool acts_as_point(SummedLight light, Surface surface) {
    vec3 way = light.middle - surface.position;
    return light.size_squared <= LARGEST_POINT * LARGEST_POINT * dot(way, way);
}

/// Triangles without a texture.
void sum_plain_triangles(Surface surface) {
    vec3 sum = vec3(0.0);  // of a group as far as it is summed
    uint group = NONE;
    uint index = 0u;
    while (index < push.plain_triangles) {
        // Those that act as points, until one turns up that does not: a subgroup then sums those of all its points together.
        bool is_near = false;
        vec3 radiance = vec3(0.0);
        while (index < push.plain_triangles && !is_near) {
            SummedLight light = summed_light(index++);
            radiance = may_shine(light, surface) ? light.radiance : vec3(0.0);
            is_near = radiance != vec3(0.0) && !acts_as_point(light, surface);
            if (light.group != group) sum = vec3(0.0);
            group = light.group;
            if (!is_near) sum += radiance * point_irradiance(light.middle, light.area, surface);
            group_irradiance[group] = sum;
        }
        if (is_near) {
            sum += radiance * triangle_irradiance(triangle_of(index - 1u), surface);
            group_irradiance[group] = sum;
        }
    }
}

void sum_textured_triangles(Surface surface) {
    for (uint index = push.plain_triangles; index < push.triangles; ++index) {
        SummedLight light = summed_light(index);
        uint first = first_piece_of(index);
        group_irradiance[light.group] += piecewise_irradiance(triangle_of(index), first, may_shine(light, surface), surface);
    }
}

void sum_others(Surface surface) {
    for (uint index = push.triangles; index < light_count(); ++index) {
        group_irradiance[summed_light(index).group] += other_irradiance(light_of(index), surface);
    }
}

/// Sets group_irradiance.
void sum_lights(Surface surface) {
    for (uint group = 0u; group < light_groups.length(); ++group) group_irradiance[group] = vec3(0.0);
    if (HAS_TRIANGLE_LIGHTS) sum_plain_triangles(surface);
    if (HAS_TRIANGLE_LIGHTS && HAS_TEXTURES) sum_textured_triangles(surface);
    if (HAS_ENVIRONMENT || HAS_PUNCTUAL_LIGHTS) sum_others(surface);
}

#endif
