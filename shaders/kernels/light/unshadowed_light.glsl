// SPDX-License-Identifier: Apache-2.0
// Light that would reach a diffuse surface if nothing stood between it and the lights, in closed form.
#ifndef UTSURI_KERNELS_LIGHT_UNSHADOWED_LIGHT
#define UTSURI_KERNELS_LIGHT_UNSHADOWED_LIGHT

#include "interop/light_pieces.h"
#include "kernels/scene/lights.glsl"
#include "lib/triangle_irradiance.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_PIECES) readonly restrict buffer LightPieces {
    vec3 light_pieces[];
};

/// A light, or a piece of one, that is no larger than this share of its distance acts as a point: of what it brings, the mean
/// over it and what its middle brings differ by less than a quarter of the square of the share. Where it straddles a horizon, or
/// a piece is dark on one side, they differ by some times the share, which is a small part of what all bring.
const float LARGEST_POINT = 0.125;

/// Irradiance from a small surface of radiance 1.
/// @param area its vector area
float point_irradiance(vec3 middle, vec3 area, Surface surface) {
    vec3 way = middle - surface.position;
    vec3 wi = normalize_any_scale(way);
    return is_above(surface, wi) ? abs(dot(area, wi)) * dot(surface.ns, wi) / dot(way, way) : 0.0;
}

float triangle_irradiance(BvhTriangle vertices, Surface surface) {
    return triangle_irradiance(vertices.v0 - surface.position, vertices.v1 - surface.position, vertices.v2 - surface.position,
                               surface.ng, surface.ns);
}

/// Irradiance from surroundings of radiance 1: the horizon of ng cuts off a part of the hemisphere of ns, which is half an
/// ellipse when projected on the plane of ns.
float environment_irradiance(Surface surface) {
    return 0.5 * PI * (1.0 + dot(surface.ng, surface.ns));
}

/// The pieces of a level of a textured triangle, as they follow each other: interop/light_pieces.h.
struct LightPiece {
    uint j;
    uint k;
};

LightPiece next_piece(LightPiece piece, uint n) {
    bool ends_row = piece.k + 2u == 2u * (n - piece.j);
    return LightPiece(piece.j + uint(ends_row), ends_row ? 0u : piece.k + 1u);
}

/// @param n pieces along an edge
BvhTriangle piece_triangle(LightPiece piece, uint n, vec3 origin, vec3 across, vec3 up) {
    float turned = float(piece.k & 1u);
    vec3 a = origin + ((float(piece.k / 2u) + turned) * across + (float(piece.j) + turned) * up) / float(n);
    float step = (1.0 - 2.0 * turned) / float(n);
    return BvhTriangle(a, a + step * across, a + step * up);
}

/// Irradiance from a textured triangle, by pieces with the mean radiance of each, as small as their distance asks for.
/// @param first of the pieces
/// @param shines whether it brings anything
vec3 piecewise_irradiance(BvhTriangle vertices, uint first, bool shines, Surface surface) {
    vec3 across = vertices.v1 - vertices.v0;
    vec3 up = vertices.v2 - vertices.v0;
    float size = sqrt(max(dot(across, across), max(dot(up, up), dot(up - across, up - across))));
    // No point of the triangle is farther from its middle than two thirds of its longest edge.
    float distance = length(vertices.v0 + (across + up) / 3.0 - surface.position) - 0.667 * size;
    uint level = 0u;
    while (level + 1u < LIGHT_PIECE_LEVELS && ldexp(size, -int(level)) > LARGEST_POINT * distance) {
        first += 1u << (2u * level);
        ++level;
    }
    bool is_far = ldexp(size, -int(level)) <= LARGEST_POINT * distance;
    uint n = 1u << level;
    uint count = shines ? n * n : 0u;
    vec3 area = 0.5 * cross(across, up) / float(n * n);
    vec3 sum = vec3(0.0);
    // A loop for each, so that points do not pay for what triangles cost.
    LightPiece piece = LightPiece(0u, 0u);
    for (uint i = 0u; i < (is_far ? count : 0u); ++i, piece = next_piece(piece, n)) {
        BvhTriangle part = piece_triangle(piece, n, vertices.v0, across, up);
        sum += light_pieces[first + i] * point_irradiance((part.v0 + part.v1 + part.v2) / 3.0, area, surface);
    }
    piece = LightPiece(0u, 0u);
    for (uint i = 0u; i < (is_far ? 0u : count); ++i, piece = next_piece(piece, n)) {
        sum += light_pieces[first + i] * triangle_irradiance(piece_triangle(piece, n, vertices.v0, across, up), surface);
    }
    return sum;
}

/// What a light that is no triangle brings to a surface, lux.
vec3 other_irradiance(uint index, Surface surface) {
    LightInfo light = lights[index];
    if (HAS_ENVIRONMENT && light.type == LIGHT_ENVIRONMENT) return environment_irradiance(surface) * light.intensity;
    LightSample s = sample_punctual_light(light, 1.0, surface);
    return is_above(surface, s.direction) ? s.irradiance * dot(surface.ns, s.direction) : vec3(0.0);
}

#endif
