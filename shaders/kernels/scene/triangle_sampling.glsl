// SPDX-License-Identifier: Apache-2.0
// Choosing a point on a light triangle.
#ifndef UTSURI_KERNELS_SCENE_TRIANGLE_SAMPLING
#define UTSURI_KERNELS_SCENE_TRIANGLE_SAMPLING

#include "lib/edge_sampling.glsl"
#include "lib/spherical_triangle.glsl"
#include "lib/triangle_geometry.glsl"
#include "kernels/scene/scene_bindings.glsl"

/// How points are chosen on a light triangle, for a receiver.
struct TriangleSampling {
    float by_view;  ///< the share of samples that are uniform over what is seen; the others are over area
    bool by_edge;   ///< of those by view: `edge` tells, else `seen`
    SphericalTriangle seen;
    SeenEdge edge;
};

/// Near lights as they are seen, or the variance has no bound; far ones by area, which costs less and differs little. Where
/// lights have textures, half by area: bright texels may be on the far end.
TriangleSampling triangle_sampling(BvhTriangle vertices, uint material, vec3 position) {
    /// Distance of the middle, in longest edges, beyond which what points of the light bring differs by a small factor only.
    const float NEAR = 1.0;
    /// Below these float32 no longer tells where in the triangle a direction is: see spherical_triangle(). So thin are tubes
    /// and triangles seen edge-on: their longest edge tells.
    const float LEAST_VOLUME = 1.0 / 4096.0;
    const float LEAST_SOLID_ANGLE = 1.0 / 4096.0;
    TriangleSampling sampling;
    sampling.by_view = 0.0;
    vec3 q0 = vertices.v0 - position;
    vec3 q1 = vertices.v1 - position;
    vec3 q2 = vertices.v2 - position;
    vec3 middle = (q0 + q1 + q2) / 3.0;
    float longest = max(dot(q1 - q0, q1 - q0), max(dot(q2 - q1, q2 - q1), dot(q0 - q2, q0 - q2)));
    if (dot(middle, middle) > NEAR * NEAR * longest) return sampling;
    sampling.seen = spherical_triangle(q0, q1, q2);
    sampling.edge = seen_edge(q0, q1, q2);
    sampling.by_edge = sampling.seen.volume < LEAST_VOLUME || sampling.seen.solid_angle < LEAST_SOLID_ANGLE;
    bool has_texture = HAS_TEXTURES && materials[material].emissive_texture.texture != NONE;
    sampling.by_view = has_texture ? 0.5 : 1.0;
    return sampling;
}

/// Density over solid angle with which direct_light() samples this point of a light triangle.
/// @param facing twice the vector area dotted with the direction from light to surface, per unit of that direction
float triangle_light_pdf(TriangleSampling sampling, float probability, float facing, vec3 to_light) {
    float by_area = 2.0 * dot(to_light, to_light) / facing;  // infinite where the triangle is seen edge-on
    if (sampling.by_view == 0.0) return probability * by_area;
    float by_view = sampling.by_edge ? by_area * edge_density(sampling.edge, to_light) : 1.0 / sampling.seen.solid_angle;
    return probability * (sampling.by_view == 1.0 ? by_view : mix(by_area, by_view, sampling.by_view));
}

/// Where a light triangle is met by a direction within what is seen of it: b1 and b2.
vec2 coordinates_on_triangle(BvhTriangle vertices, vec3 position, vec3 direction) {
    vec3 q0 = vertices.v0 - position;
    vec3 q1 = vertices.v1 - position;
    vec3 q2 = vertices.v2 - position;
    // No product of three lengths overflows or vanishes.
    direction *= power_of_two_reciprocal(max_component(abs(q0) + abs(q1) + abs(q2)));
    vec3 parts = vec3(dot(direction, cross(q1, q2)), dot(direction, cross(q2, q0)), dot(direction, cross(q0, q1)));
    // All have one sign, but for rounding at the edges.
    float whole = parts.x + parts.y + parts.z;
    vec3 b = max(parts / whole, vec3(0.0));
    return b.yz / (b.x + b.y + b.z);
}

/// Uniform over the triangle, without the square root's clumping of stratified samples (Heitz 2019): b1 and b2.
vec2 uniform_coordinates(vec2 u) {
    return u.x < u.y ? vec2(0.5 * u.x, u.y - 0.5 * u.x) : vec2(u.x - 0.5 * u.y, 0.5 * u.y);
}

vec2 sample_triangle(TriangleSampling sampling, BvhTriangle vertices, vec3 position, vec2 u) {
    if (u.x >= sampling.by_view) {
        return uniform_coordinates(vec2((u.x - sampling.by_view) / (1.0 - sampling.by_view), u.y));
    }
    vec2 within = vec2(u.x / sampling.by_view, u.y);
    if (sampling.by_edge) return sample_edge(sampling.edge, within);
    return coordinates_on_triangle(vertices, position, sample_spherical_triangle(sampling.seen, within));
}

#endif
