// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/lobe_albedo.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace utsuri {
namespace {

/// Points of the quadrature, a Fibonacci lattice in the unit square.
constexpr int kPoints = 987;
constexpr int kGenerator = 610;

/// The least width and cosine that are told apart from zero, where the limits are 1 and 0.
constexpr double kLeast = 1e-4;

double schlick_weight(double cosine) {
    return std::pow(std::clamp(1.0 - cosine, 0.0, 1.0), 5.0);
}

/// A GGX normal visible from `wo`, the surface's normal being +z (Dupuy and Benyoub 2023).
glm::dvec3 visible_normal(const glm::dvec3& wo, double alpha, double u, double v) {
    const glm::dvec3 standard = glm::normalize(glm::dvec3(alpha * wo.x, alpha * wo.y, wo.z));
    const double turn = 2.0 * std::numbers::pi * u;
    const double z = (1.0 - v) * (1.0 + standard.z) - standard.z;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const glm::dvec3 h = standard + glm::dvec3(radius * std::cos(turn), radius * std::sin(turn), z);
    return glm::normalize(glm::dvec3(alpha * h.x, alpha * h.y, h.z));
}

/// Height-correlated Smith masking of both directions over that of wo alone (Heitz 2014).
double smith_share(double cos_o, double cos_i, double alpha) {
    const auto root = [&](double mu) { return std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * mu * mu); };
    return cos_i * (cos_o + root(cos_o)) / (cos_i * root(cos_o) + cos_o * root(cos_i));
}

}  // namespace

interop::LobeAlbedo lobe_albedo(double alpha, double mu) {
    alpha = std::max(alpha, kLeast);
    mu = std::max(mu, kLeast);
    const glm::dvec3 wo(std::sqrt(1.0 - mu * mu), 0.0, mu);
    double whole = 0.0;
    double schlick = 0.0;
    double lost = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        // One half of the turn stands for both.
        const double u = 0.5 * (i * kGenerator % kPoints + 0.5) / kPoints;
        const double v = (i + 0.5) / kPoints;
        const glm::dvec3 h = visible_normal(wo, alpha, u, v);
        const double cos_h = glm::dot(wo, h);
        const double cos_i = 2.0 * cos_h * h.z - wo.z;
        if (cos_i > 0.0) {
            const double share = smith_share(mu, cos_i, alpha);
            whole += share;
            schlick += share * schlick_weight(cos_h);
        }
        const double turn = 2.0 * std::numbers::pi * u;
        const glm::dvec3 wi(std::sqrt(v) * std::cos(turn), std::sqrt(v) * std::sin(turn), std::sqrt(1.0 - v));
        lost += schlick_weight(glm::dot(wo, glm::normalize(wo + wi)));
    }
    return {static_cast<float>((whole - schlick) / kPoints), static_cast<float>(schlick / kPoints),
            static_cast<float>(lost / kPoints)};
}

namespace {

std::vector<interop::LobeAlbedo> make_lobe_albedo_table() {
    std::vector<interop::LobeAlbedo> table;
    constexpr double kLast = interop::LOBE_ALBEDO_SIZE - 1;
    for (std::uint32_t row = 0; row < interop::LOBE_ALBEDO_SIZE; ++row) {
        for (std::uint32_t column = 0; column < interop::LOBE_ALBEDO_SIZE; ++column) {
            const double roughness = row / kLast;
            const double root_mu = column / kLast;
            table.push_back(lobe_albedo(roughness * roughness, root_mu * root_mu));
        }
    }
    return table;
}

}  // namespace

const std::vector<interop::LobeAlbedo>& lobe_albedo_table() {
    static const std::vector<interop::LobeAlbedo> kTable = make_lobe_albedo_table();
    return kTable;
}

}  // namespace utsuri
