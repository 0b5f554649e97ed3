// SPDX-License-Identifier: Apache-2.0
// Glossy lobes reflect surfaces that are lit, not only lights. Closed forms: under a ceiling that sends out
// radiance 1 everywhere, a plate shows its directional albedo.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Directions under a slope of 1 to this miss a ceiling at height 1: a millionth of what a plate reflects.
constexpr float kFar = 1000.0f;

class GlossyReflections : public DeviceTest {
  protected:
    static Estimate plate(Observer& observer, double mu, std::uint32_t samples) {
        return observer.look({std::sqrt(1.0 - mu * mu), mu, 0.0}, {0.0, 0.0, 0.0}, samples);
    }
};

/// Sends `radiance` out everywhere without a light in sample of the plate: a sun from below the plate's
/// horizon lights a diffuse ceiling evenly. The plate's shadow there is too small to count.
void add_lit_ceiling(Scene& scene, float radiance) {
    Light sun;
    sun.type = LightType::directional;
    sun.direction = glm::normalize(glm::dvec3(1.0, 1.0, 0.0));
    sun.intensity = glm::vec3(static_cast<float>(kPi * std::numbers::sqrt2) * radiance);
    scene.lights.push_back(sun);
    add(scene, ceiling({0.0f, 1.0f, 0.0f}, kFar), lambert(glm::vec3(1.0f)));
}

Scene plate_under_ceiling(const Material& material) {
    Scene scene;
    add(scene, ground(1e-3f), material);
    add_lit_ceiling(scene, 1.0f);
    return scene;
}

Material metal_of(double alpha, float f0 = 1.0f) {
    return glossy_metal(static_cast<float>(std::sqrt(alpha)), glm::vec3(f0));
}

struct AlbedoRow {
    double alpha;
    std::array<double, 3> albedo;  ///< at kCosines
};
constexpr std::array<double, 3> kCosines = {1.0, 0.70710678, 0.25};

// GGX with height-correlated Smith masking and F = 1, by float64 quadrature: references.md A3.4.
constexpr std::array<AlbedoRow, 3> kGgxAlbedo = {{{0.04, {0.998298, 0.997372, 0.983592}},
                                                  {0.25, {0.915812, 0.886244, 0.840082}},
                                                  {1.00, {0.306853, 0.376775, 0.597641}}}};

TEST_F(GlossyReflections, MetalUnderALitCeilingShowsItsDirectionalAlbedo) {
    for (const AlbedoRow& row : kGgxAlbedo) {
        Observer observer(device(), plate_under_ceiling(metal_of(row.alpha)));
        for (std::size_t i = 0; i < kCosines.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "alpha " << row.alpha << ", cosine " << kCosines[i]);
            expect_radiance(plate(observer, kCosines[i], 256), row.albedo[i]);
        }
    }
}

// A ceiling that shines and reflects: its emission is shared with light samples, its reflection is not.
TEST_F(GlossyReflections, EmittedAndReflectedLightAddUp) {
    Scene scene;
    add(scene, ground(1e-3f), metal_of(0.25));
    add_lit_ceiling(scene, 0.5f);
    scene.materials.back().emissive = glm::vec3(0.5f);
    Observer observer(device(), scene);
    expect_radiance(plate(observer, 0.70710678, 1024), 0.886244);
}

// The Lambert lobe ends the chain; the rough one of F0 = 0.04 does not. Its albedo is F0 A + B of
// references.md A3.5.
TEST_F(GlossyReflections, OnlyTheGlossyLobeOfADielectricReflectsSurfaces) {
    Material material = lambert(glm::vec3(0.5f));
    material.specular = 1.0f;
    material.roughness = 0.5f;
    Observer observer(device(), plate_under_ceiling(material));
    expect_radiance(plate(observer, 0.5, 1024), 0.04 * 0.834916 + 0.022347);
}

// A mirror of reflectance 1 so small that it hides nothing: the plate at its image, seen at 45 degrees.
TEST_F(GlossyReflections, AMirrorShowsThemUnchanged) {
    Scene scene = plate_under_ceiling(metal_of(0.25));
    add(scene, quad({-0.5f, 0.499f, -1e-3f}, {0, 2e-3f, 0}, {0, 0, 2e-3f}), mirror());
    Observer observer(device(), scene);
    expect_radiance(observer.look({-0.25, 0.75, 0.0}, {-0.5, 0.5, 0.0}, 256), 0.886244);
    EXPECT_EQ(observer.counts().truncated, 0u);
}

// At a depth of 0 lobes reflect lights only: all of a shining ceiling, nothing of one that is lit.
TEST_F(GlossyReflections, TheDepthBoundsReflectionsButNotDirectLight) {
    RenderSettings settings;
    settings.width = settings.height = kCloseUpSize;
    settings.max_depth = 0;
    const double mu = 0.70710678;
    const Camera camera = look_at({mu, mu, 0.0}, {0.0, 0.0, 0.0}, kCloseUpAngle);

    Observer lit(device(), plate_under_ceiling(metal_of(0.25)));
    for (const glm::vec3& pixel : lit.picture(camera, settings, 4).pixels)
        ASSERT_EQ(pixel, glm::vec3(0.0f));
    EXPECT_GT(lit.counts().lookups, 0u);
    EXPECT_EQ(lit.counts().truncated, lit.counts().lookups);

    Scene scene;
    add(scene, ground(1e-3f), metal_of(0.25));
    add(scene, ceiling({0.0f, 1.0f, 0.0f}, kFar), emitter(glm::vec3(1.0f)));
    Observer shining(device(), scene);
    expect_radiance(estimate_of(shining.picture(camera, settings, 1024)), 0.886244);
}

/// Two half planes of GGX metal that meet at a right angle, in a uniform environment of radiance 1, by brute
/// force: directions uniform over the hemisphere, in float64, with nothing but the BRDF in common with the
/// device. Where the planes reach to infinity, what a ray meets follows from its direction alone.
class Corner {
  public:
    Corner(double alpha, double f0) : alpha_(alpha), f0_(f0) {}

    /// One sample of the radiance towards wo from the floor (y = 0), whose normal is +y.
    double sample(glm::dvec3 wo) {
        double throughput = 1.0;
        for (;;) {
            const double u = number();
            const double turn = 2.0 * kPi * number();
            const double radius = std::sqrt(1.0 - u * u);
            const glm::dvec3 wi(radius * std::cos(turn), u, radius * std::sin(turn));
            throughput *= 2.0 * kPi * brdf(wo, wi) * wi.y;
            if (wi.x >= 0.0) return throughput;
            // The wall (x = 0) becomes the floor.
            wo = glm::dvec3(-wi.y, -wi.x, -wi.z);
        }
    }

  private:
    double number() { return static_cast<double>(engine_()) * 0x1p-32; }

    [[nodiscard]] double brdf(const glm::dvec3& wo, const glm::dvec3& wi) const {
        const glm::dvec3 h = glm::normalize(wo + wi);
        const double a2 = alpha_ * alpha_;
        const double d = a2 / (kPi * std::pow(h.y * h.y * (a2 - 1.0) + 1.0, 2.0));
        const auto root = [&](double cosine) { return std::sqrt(a2 + (1.0 - a2) * cosine * cosine); };
        const double v = 0.5 / (wi.y * root(wo.y) + wo.y * root(wi.y));
        return d * v * (f0_ + (1.0 - f0_) * std::pow(1.0 - glm::dot(wo, h), 5.0));
    }

    double alpha_;
    double f0_;
    std::mt19937 engine_{5};
};

TEST_F(GlossyReflections, GlossySurfacesReflectEachOther) {
    constexpr float kF0 = 0.8f;
    constexpr int kSamples = 1 << 23;
    for (const double alpha : {0.3, 1.0}) {
        SCOPED_TRACE(alpha);
        Scene scene;
        scene.environment = glm::vec3(1.0f);
        add(scene, quad({0, 0, -kFar}, {0, 0, 2 * kFar}, {kFar, 0, 0}), metal_of(alpha, kF0));
        add(scene, quad({0, 0, -kFar}, {0, kFar, 0}, {0, 0, 2 * kFar}), metal_of(alpha, kF0));
        Observer observer(device(), scene);
        RenderSettings settings;
        settings.width = settings.height = kCloseUpSize;
        settings.max_depth = 64;
        const glm::dvec3 wo = glm::normalize(glm::dvec3(1.0, 0.7, 0.4));
        const glm::dvec3 point(0.1, 0.0, 0.0);
        const Estimate estimate =
            estimate_of(observer.picture(look_at(point + wo, point, kCloseUpAngle), settings, 1024));
        Corner corner(alpha, static_cast<double>(kF0));
        double sum = 0.0;
        double squares = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const double value = corner.sample(wo);
            sum += value / kSamples;
            squares += value * value / kSamples;
        }
        const double error =
            std::hypot(std::sqrt((squares - sum * sum) / kSamples), estimate.standard_error.x);
        EXPECT_LE(error, 2e-3 * sum) << "too noisy to tell";
        EXPECT_NEAR(estimate.mean.x, sum, kSigmas * error);
    }
}

}  // namespace
}  // namespace utsuri::test
