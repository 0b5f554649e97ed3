// SPDX-License-Identifier: Apache-2.0
#include "kernels/microfacet_probe.h"

#include "support/test_device.h"

#include "base/sampler.h"
#include "gpu/probe.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace utsuri {
namespace {

/// Deterministic float32 arithmetic of under thirty roundings without cancellation: 30 * 2^-24.
constexpr double kDeterministic = 2e-6;

/// A direction `polar` degrees off +z, turned by `azimuth` degrees.
glm::vec3 direction(double polar, double azimuth) {
    const double theta = polar * std::numbers::pi / 180.0;
    const double phi = azimuth * std::numbers::pi / 180.0;
    return glm::vec3(
        glm::dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
}

class MicrofacetProbe : public DeviceTest {
  protected:
    static std::vector<interop::MicrofacetAnswer> ask(const std::vector<interop::MicrofacetQuery>& queries) {
        return test::ask<interop::MicrofacetAnswer>(device(), "microfacet_probe", kernels::microfacet_probe,
                                                    queries);
    }
};

/// Values of the GGX lobe with height-correlated Smith masking and F = 1, from its definition in 30-digit
/// arithmetic (Walter et al. 2007; Heitz 2014), at polar angles of wi and wo and the azimuth between them.
struct PointValue {
    double polar_i;
    double polar_o;
    double azimuth;
    double half;   ///< alpha = 0.5
    double tenth;  ///< alpha = 0.1
};
constexpr PointValue kPointValues[] = {
    {0, 0, 0, 0.318309886, 7.95774715},    {45, 45, 180, 0.569410035, 15.8365087},
    {60, 0, 0, 0.178981465, 0.0238256359}, {60, 30, 90, 0.148476504, 0.0144281581},
    {80, 80, 180, 3.51078966, 229.558836}, {80, 70, 170, 1.33637300, 0.997716444}};

TEST_F(MicrofacetProbe, HasTheKnownPointValues) {
    // D falls as a power of (sin / alpha)^2 of the half angle; its relative error is that of the half
    // vector's sine, up to four times the rounding of the directions themselves over that sine. The smallest
    // here is 5 degrees.
    const double kDirections = 4.0 * 0x1p-24 * 4.0 / std::sin(5.0 * std::numbers::pi / 180.0);
    std::vector<interop::MicrofacetQuery> queries;
    for (const PointValue& value : kPointValues) {
        const glm::vec3 wi = direction(value.polar_i, 0.0);
        const glm::vec3 wo = direction(value.polar_o, value.azimuth);
        for (const float alpha : {0.5f, 0.1f}) {
            queries.push_back({{0, 0, 1}, wo, wi, alpha, {0.5f, 0.5f}});
            queries.push_back({{0, 0, 1}, wi, wo, alpha, {0.5f, 0.5f}});  // reciprocity
        }
    }
    const auto answers = ask(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const PointValue& value = kPointValues[i / 4];
        const double expected = i % 4 < 2 ? value.half : value.tenth;
        EXPECT_NEAR(static_cast<double>(answers[i].brdf), expected, expected * (kDeterministic + kDirections))
            << "angles " << value.polar_i << ", " << value.polar_o << ", " << value.azimuth;
    }
    for (std::size_t i = 0; i < queries.size(); i += 2) {
        const auto there = static_cast<double>(answers[i].brdf);
        EXPECT_NEAR(static_cast<double>(answers[i + 1].brdf), there, 1e-6 * there) << "directions swapped";
    }
}

TEST_F(MicrofacetProbe, KeepsItsDigitsInNarrowLobes) {
    // D(h) = alpha^2 / (pi (alpha^2 cos^2 + sin^2)^2), evaluated in float64 for the float32 half vector. The
    // textbook form with cos^2 (alpha^2 - 1) + 1 loses 12 % at alpha = 1e-3.
    std::vector<interop::MicrofacetQuery> queries;
    for (const float alpha : {0.1f, 0.03f, 0.01f, 3e-3f, 1e-3f}) {
        for (int step = 0; step <= 30; ++step) {
            const double half = 0.1 * step * static_cast<double>(alpha);
            const glm::vec3 h(glm::dvec3(std::sin(half), 0.0, std::cos(half)));
            // wo = wi = h: normalising their sum gives h back up to its rounding.
            queries.push_back({{0, 0, 1}, h, h, alpha, {0.5f, 0.5f}});
        }
    }
    const auto answers = ask(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const auto alpha = static_cast<double>(queries[i].alpha);
        const glm::dvec3 h = glm::normalize(glm::dvec3(queries[i].wo));
        const double sine_squared = h.x * h.x + h.y * h.y;
        const double d = alpha * alpha * h.z * h.z + sine_squared;
        const double expected = alpha * alpha / (std::numbers::pi * d * d);
        EXPECT_NEAR(static_cast<double>(answers[i].distribution), expected, kDeterministic * expected)
            << alpha;
    }
}

TEST_F(MicrofacetProbe, SamplesUnitNormalsOnTheViewersSide) {
    std::vector<interop::MicrofacetQuery> queries;
    for (const float alpha : {1e-3f, 0.1f, 1.0f}) {
        for (const double polar : {0.0, 45.0, 89.0, 89.99}) {
            for (std::uint32_t i = 0; i < 256; ++i) {
                queries.push_back({{0, 0, 1}, direction(polar, 30.0), {0, 0, 1}, alpha, sample_2d(9, i, 0)});
            }
        }
    }
    const std::size_t inside = queries.size();
    // Corners of the unit square, with the largest number a sample can be.
    const float last = 1.0f - 0x1p-24f;
    for (const glm::vec2 u :
         {glm::vec2(0.0f), glm::vec2(0.0f, last), glm::vec2(last, 0.0f), glm::vec2(last)}) {
        queries.push_back({{0, 0, 1}, direction(60.0, 0.0), {0, 0, 1}, 0.25f, u});
        queries.push_back({{0, 0, -1}, -direction(60.0, 0.0), {0, 0, -1}, 0.25f, u});
    }
    const auto answers = ask(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const glm::dvec3 h(answers[i].sampled_normal);
        // Two normalisations, a basis and a sum: the allowance of bases, 1e-6.
        ASSERT_NEAR(glm::length(h), 1.0, 1e-6) << i;
        ASSERT_GT(glm::dot(h, glm::dvec3(queries[i].normal)), 0.0) << i;
        // In the corners the half vector is what cancellation leaves of two opposite ones.
        if (i >= inside) continue;
        ASSERT_GT(glm::dot(h, glm::dvec3(queries[i].wo)), -1e-6) << "visible from wo, " << i;
    }
}

TEST_F(MicrofacetProbe, DensityIsThatOfVisibleNormalsOverFour) {
    // pdf(wi) = G1(wo) D(h) / (4 cos_o) with G1 = 2 cos / (cos + sqrt(alpha^2 + (1 - alpha^2) cos^2)).
    std::vector<interop::MicrofacetQuery> queries;
    for (const double polar : {0.0, 30.0, 60.0, 85.0}) {
        for (const float alpha : {0.1f, 0.5f, 1.0f}) {
            queries.push_back({{0, 0, 1}, direction(polar, 0.0), direction(40.0, 70.0), alpha, {0.5f, 0.5f}});
        }
    }
    const auto answers = ask(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const auto a2 = std::pow(static_cast<double>(queries[i].alpha), 2.0);
        const auto cosine = static_cast<double>(queries[i].wo.z);
        const double g1 = 2.0 * cosine / (cosine + std::sqrt(a2 + (1.0 - a2) * cosine * cosine));
        const double expected = g1 * static_cast<double>(answers[i].distribution) / (4.0 * cosine);
        EXPECT_NEAR(static_cast<double>(answers[i].pdf), expected, kDeterministic * expected);
    }
}

}  // namespace
}  // namespace utsuri
