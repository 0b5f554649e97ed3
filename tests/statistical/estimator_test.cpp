// SPDX-License-Identifier: Apache-2.0
// Estimates of direct light against float64 quadrature and closed forms: no bias beyond what their spread
// explains.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "chi_square.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;

class Estimator : public DeviceTest {};

struct Gloss {
    double alpha;
    double base;  ///< base colour
    bool metal;
};

/// The metallic-roughness BRDF of glTF 2.0 (appendix B) in float64, the normal being +y.
double brdf(const Gloss& gloss, const glm::dvec3& wo, const glm::dvec3& wi) {
    const glm::dvec3 h = glm::normalize(wo + wi);
    const double a2 = gloss.alpha * gloss.alpha;
    const double d = a2 / (kPi * std::pow(h.y * h.y * (a2 - 1.0) + 1.0, 2.0));
    const auto root = [&](double cosine) { return std::sqrt(a2 + (1.0 - a2) * cosine * cosine); };
    const double v = 0.5 / (wi.y * root(wo.y) + wo.y * root(wi.y));
    const double schlick = std::pow(1.0 - glm::dot(wo, h), 5.0);
    const double f0 = gloss.metal ? gloss.base : 0.04;
    const double f = f0 + (1.0 - f0) * schlick;
    return f * d * v + (gloss.metal ? 0.0 : (1.0 - f) * gloss.base / kPi);
}

constexpr glm::dvec3 kLightCentre(-0.5, 1.0, 0.1);
constexpr double kLightHalf = 0.5;

/// Radiance that the square light sends by way of the origin towards wo: midpoint rule over the light.
double quadrature(const Gloss& gloss, const glm::dvec3& wo) {
    constexpr int kSteps = 800;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const glm::dvec3 offset(2.0 * (i + 0.5) / kSteps - 1.0, 0.0, 2.0 * (j + 0.5) / kSteps - 1.0);
            const glm::dvec3 to_light = kLightCentre + kLightHalf * offset;
            const double distance2 = glm::dot(to_light, to_light);
            const glm::dvec3 wi = to_light / std::sqrt(distance2);
            sum += brdf(gloss, wo, wi) * wi.y * wi.y / distance2;
        }
    }
    return sum * 4.0 * kLightHalf * kLightHalf / (kSteps * kSteps);
}

Material material_of(const Gloss& gloss) {
    Material material;
    material.base_colour = glm::vec3(static_cast<float>(gloss.base));
    material.metallic = gloss.metal ? 1.0f : 0.0f;
    material.roughness = static_cast<float>(std::sqrt(gloss.alpha));
    return material;
}

// Lobes from far narrower to wider than the light, seen where they reflect it, beside it and at grazing
// angles.
TEST_F(Estimator, GlossyLightMatchesQuadrature) {
    const std::array<Gloss, 6> cases = {{{0.02, 1.0, true},
                                         {0.1, 0.5, true},
                                         {0.3, 1.0, true},
                                         {1.0, 0.8, true},
                                         {0.1, 0.5, false},
                                         {0.5, 0.9, false}}};
    for (const Gloss& gloss : cases) {
        Scene scene;
        add(scene, ground(1.0f), material_of(gloss));
        add(scene, ceiling(glm::vec3(kLightCentre), static_cast<float>(kLightHalf)),
            emitter(glm::vec3(1.0f)));
        Observer observer(device(), scene);
        for (const glm::dvec3 eye :
             {glm::dvec3(0.6, 1, 0), glm::dvec3(1, 0.9, -0.9), glm::dvec3(2, 0.3, 0.1)}) {
            SCOPED_TRACE(testing::Message()
                         << "alpha " << gloss.alpha << (gloss.metal ? " metal" : " dielectric") << ", eye "
                         << eye.x << ' ' << eye.y << ' ' << eye.z);
            const double expected = quadrature(gloss, glm::normalize(eye));
            expect_radiance(observer.look(eye, {0, 0, 0}, 1024), expected, 1e-3);
        }
    }
}

// Square lights at 24 places, all above the horizon: each estimate's distance from Lambert's polygon sum in
// units of its standard error. One may be off by chance; together they must look like a standard normal
// variable.
TEST_F(Estimator, ZScoresAreStandardNormal) {
    constexpr int kPlaces = 24;
    std::mt19937 engine(11);
    const auto number = [&] { return static_cast<double>(engine()) * 0x1p-32; };
    double sum = 0.0;
    double squares = 0.0;
    for (int place = 0; place < kPlaces; ++place) {
        const glm::dvec3 centre(3.0 * number() - 1.5, 0.4 + 2.0 * number(), 3.0 * number() - 1.5);
        const double half = 0.1 + 0.5 * number();
        Scene scene;
        add(scene, ground(0.1f), lambert(glm::vec3(1.0f)));
        add(scene, ceiling(glm::vec3(centre), static_cast<float>(half)), emitter(glm::vec3(1.0f)));
        const std::array<glm::dvec3, 4> corners = {
            {centre + glm::dvec3(-half, 0, -half), centre + glm::dvec3(half, 0, -half),
             centre + glm::dvec3(half, 0, half), centre + glm::dvec3(-half, 0, half)}};
        const double expected = std::abs(polygon_irradiance(corners, glm::dvec3(0.0), {0, 1, 0})) / kPi;
        // From the side, below every light.
        const Estimate estimate = Observer(device(), scene).look({3, 0.3, 1}, {0, 0, 0}, 16);
        const double z = (estimate.mean.x - expected) / estimate.standard_error.x;
        EXPECT_LE(std::abs(z), kSigmas);
        sum += z;
        squares += z * z;
    }
    EXPECT_LE(std::abs(sum) / std::sqrt(double{kPlaces}), kSigmas);
    EXPECT_GE(chi_square_tail(squares, kPlaces), kRejection);
    EXPECT_LE(chi_square_tail(squares, kPlaces), 1.0 - kRejection);
}

}  // namespace
}  // namespace utsuri::test
