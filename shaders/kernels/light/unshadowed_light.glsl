// SPDX-License-Identifier: Apache-2.0
// Light that would reach a diffuse surface if nothing stood between it and the lights, in closed form.
#ifndef UTSURI_KERNELS_LIGHT_UNSHADOWED_LIGHT
#define UTSURI_KERNELS_LIGHT_UNSHADOWED_LIGHT

#include "interop/light_pieces.h"
#include "kernels/scene/lights.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_FIRST_LIGHT_PIECES) readonly restrict buffer FirstLightPieces {
    uint first_light_pieces[];  ///< of each light, or NONE
};
layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_PIECES) readonly restrict buffer LightPieces {
    vec3 light_pieces[];
};

/// Twice the part of Lambert's contour integral (1760) along the great circle from unit vector a to b.
float contour_part(vec3 a, vec3 b, vec3 n) {
    vec3 across = cross(a, b);
    float sine = length(across);
    return sine > 0.0 ? angle_of(sine, dot(a, b)) * dot(across, n) / sine : 0.0;
}

/// Where the great circle from a above the horizon to b below it meets the horizon.
vec3 horizon_point(vec3 a, vec3 b, vec3 n) {
    return normalize_any_scale(a * -dot(b, n) + b * dot(a, n));
}

/// Pieces are no larger than this share of their distance, as long as there are smaller ones. Such a piece acts as a point: what
/// it brings is off by the square of the share, and a piece that is dark on one side by some times the share, which is a small
/// part of what all bring.
const float LARGEST_PIECE = 0.125;

/// A triangle as seen from a point, cut by the horizons of both normals: unit directions to its corners.
struct SeenPolygon {
    vec3 corners[6];  ///< a cut adds one, and where rounding decides on which side corners are, one more
    uint count;
};

/// What of a polygon is above the horizon of n (Sutherland and Hodgman 1974).
SeenPolygon above_horizon(SeenPolygon polygon, vec3 n) {
    SeenPolygon above;
    above.count = 0u;
    for (uint i = 0u; i < polygon.count; ++i) {
        vec3 a = polygon.corners[i];
        vec3 b = polygon.corners[i + 1u < polygon.count ? i + 1u : 0u];
        bool a_above = dot(a, n) > 0.0;
        bool b_above = dot(b, n) > 0.0;
        if (a_above) above.corners[above.count++] = a;
        if (a_above && !b_above) above.corners[above.count++] = horizon_point(a, b, n);
        if (!a_above && b_above) above.corners[above.count++] = horizon_point(b, a, n);
    }
    return above;
}

/// Irradiance at a surface from a triangle of radiance 1, of which only what is above both its normals' horizons shines.
float triangle_irradiance(BvhTriangle vertices, Surface surface) {
    SeenPolygon seen;
    seen.corners[0] = normalize_any_scale(vertices.v0 - surface.position);
    seen.corners[1] = normalize_any_scale(vertices.v1 - surface.position);
    seen.corners[2] = normalize_any_scale(vertices.v2 - surface.position);
    seen.count = 3u;
    seen = above_horizon(seen, surface.ns);
    if (surface.ng != surface.ns) seen = above_horizon(seen, surface.ng);
    float sum = 0.0;
    for (uint i = 0u; i < seen.count; ++i) {
        sum += contour_part(seen.corners[i], seen.corners[i + 1u < seen.count ? i + 1u : 0u], surface.ns);
    }
    return 0.5 * abs(sum);
}

/// Irradiance from surroundings of radiance 1: the horizon of ng cuts off a part of the hemisphere of ns, which is half an
/// ellipse when projected on the plane of ns.
float environment_irradiance(Surface surface) {
    return 0.5 * PI * (1.0 + dot(surface.ng, surface.ns));
}

/// Irradiance from a small surface of radiance 1.
/// @param area its vector area
float point_irradiance(vec3 middle, vec3 area, Surface surface) {
    vec3 way = middle - surface.position;
    vec3 wi = normalize_any_scale(way);
    return is_above(surface, wi) ? abs(dot(area, wi)) * dot(surface.ns, wi) / dot(way, way) : 0.0;
}

/// Irradiance from a textured triangle, by pieces with the mean radiance of each, as small as their distance asks for.
vec3 piecewise_irradiance(BvhTriangle vertices, uint first, Surface surface) {
    vec3 across = vertices.v1 - vertices.v0;
    vec3 up = vertices.v2 - vertices.v0;
    float size = sqrt(max(dot(across, across), max(dot(up, up), dot(up - across, up - across))));
    // No point of the triangle is farther from its middle than two thirds of its longest edge.
    float distance = length(vertices.v0 + (across + up) / 3.0 - surface.position) - 0.667 * size;
    uint level = 0u;
    while (level + 1u < LIGHT_PIECE_LEVELS && ldexp(size, -int(level)) > LARGEST_PIECE * distance) {
        first += 1u << (2u * level);
        ++level;
    }
    bool is_far = ldexp(size, -int(level)) <= LARGEST_PIECE * distance;
    uint n = 1u << level;
    vec3 sum = vec3(0.0);
    for (uint j = 0u; j < n; ++j) {
        for (uint k = 0u; k < 2u * (n - j) - 1u; ++k) {
            vec3 radiance = light_pieces[first++];
            if (radiance == vec3(0.0)) continue;
            float i = float(k / 2u);
            float turned = float(k & 1u);
            vec3 a = vertices.v0 + ((i + turned) * across + (float(j) + turned) * up) / float(n);
            vec3 step = (1.0 - 2.0 * turned) * across / float(n);
            vec3 rise = (1.0 - 2.0 * turned) * up / float(n);
            sum += radiance * (is_far ? point_irradiance(a + (step + rise) / 3.0, 0.5 * cross(step, rise), surface)
                                      : triangle_irradiance(BvhTriangle(a, a + step, a + rise), surface));
        }
    }
    return sum;
}

/// What one light brings to a surface, in lux.
vec3 unshadowed_irradiance(uint index, Surface surface) {
    LightInfo light = lights[index];
    if (HAS_TRIANGLE_LIGHTS && light.type == LIGHT_TRIANGLE) {
        BvhTriangle vertices = bvh_triangle(light.triangle);
        bool front = dot(triangle_cross(vertices), surface.position - vertices.v0) > 0.0;
        if (HAS_TEXTURES && first_light_pieces[index] != NONE) {
            if (!front && materials[triangle_infos[light.triangle].material].double_sided == 0u) return vec3(0.0);
            return piecewise_irradiance(vertices, first_light_pieces[index], surface);
        }
        vec3 radiance = emitted_radiance(materials[triangle_infos[light.triangle].material], vec2(0.0), front);
        return radiance == vec3(0.0) ? radiance : radiance * triangle_irradiance(vertices, surface);
    }
    if (HAS_ENVIRONMENT && light.type == LIGHT_ENVIRONMENT) return environment_irradiance(surface) * light.intensity;
    LightSample s = sample_punctual_light(light, 1.0, surface);
    if (!is_above(surface, s.direction)) return vec3(0.0);
    return s.irradiance * dot(surface.ns, s.direction);
}

vec3 unshadowed_irradiance(Surface surface) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < light_count(); ++i) sum += unshadowed_irradiance(i, surface);
    return sum;
}

#endif
