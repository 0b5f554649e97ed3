// SPDX-License-Identifier: Apache-2.0
// The GGX microfacet distribution (Walter et al. 2007) with height-correlated Smith masking (Heitz 2014).
#ifndef UTSURI_LIB_MICROFACET
#define UTSURI_LIB_MICROFACET

#include "lib/basis.glsl"
#include "lib/numeric.glsl"
#include "lib/trigonometry.glsl"

/// D(h). The sine comes from a cross product: 1 - cos^2 would lose all digits for small alpha.
float ggx_distribution(vec3 n, vec3 h, float alpha) {
    float cosine = dot(n, h);
    vec3 sine = cross(n, h);
    float a2 = alpha * alpha;
    float d = a2 * cosine * cosine + dot(sine, sine);
    return a2 / (PI * d * d);
}

/// sqrt(cos^2 + alpha^2 sin^2) for a direction at cosine `mu`.
float smith_root(float mu, float alpha) {
    float a2 = alpha * alpha;
    return sqrt(a2 + (1.0 - a2) * mu * mu);
}

/// G2(wo, wi) / (4 cos_o cos_i).
float smith_visibility(float cos_o, float cos_i, float alpha) {
    return 0.5 / (cos_i * smith_root(cos_o, alpha) + cos_o * smith_root(cos_i, alpha));
}

/// G2(wo, wi) / G1(wo): the share of a visible microfacet's light that gets past the others, at most 1.
float smith_share(float cos_o, float cos_i, float alpha) {
    float root_o = smith_root(cos_o, alpha);
    return cos_i * (cos_o + root_o) / (cos_i * root_o + cos_o * smith_root(cos_i, alpha));
}

/// Density over solid angle of the direction that sample_ggx() gives: G1(wo) D(h) / (4 cos_o).
float ggx_pdf(vec3 n, vec3 h, float cos_o, float alpha) {
    return ggx_distribution(n, h, alpha) / (2.0 * (cos_o + smith_root(cos_o, alpha)));
}

/// A microfacet normal from the distribution of those visible from wo, which is above n (Dupuy and Benyoub 2023).
vec3 sample_ggx_normal(vec3 n, vec3 wo, float alpha, vec2 u) {
    vec3 tangent, bitangent;
    make_basis(n, tangent, bitangent);
    vec3 local = vec3(dot(wo, tangent), dot(wo, bitangent), dot(wo, n));
    vec3 standard = normalize(vec3(local.xy * alpha, local.z));
    float z = (1.0 - u.y) * (1.0 + standard.z) - standard.z;
    float radius = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    vec3 cap = vec3(radius * cos_sin_of_turn(u.x), z);
    vec3 half_vector = cap + standard;
    vec3 h = normalize(vec3(half_vector.xy * alpha, half_vector.z));
    return h.x * tangent + h.y * bitangent + h.z * n;
}

/// Schlick's approximation of the Fresnel reflectance (1994).
vec3 schlick(vec3 f0, vec3 f90, float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}

#endif
