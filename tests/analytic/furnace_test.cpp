// SPDX-License-Identifier: Apache-2.0
// White furnace: under a uniform environment of radiance 1 a pixel is the surface's directional albedo.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <array>
#include <cmath>

namespace utsuri::test {
namespace {

class Furnace : public DeviceTest {
  protected:
    /// What a plate shows at the cosine `mu` to its normal.
    static Estimate plate(Observer& observer, double mu, std::uint32_t samples) {
        return observer.look({std::sqrt(1.0 - mu * mu), mu, 0.0}, {0.0, 0.0, 0.0}, samples);
    }
};

Scene plate_in_furnace(const Material& material, float half = 1.0f) {
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    add(scene, ground(half), material);
    return scene;
}

constexpr std::array<double, 4> kCosines = {1.0, 0.70710678, 0.5, 0.25};

// E = pi L, so L = albedo * L: the cosine-weighted samples carry no noise at all.
TEST_F(Furnace, LambertPlateShowsItsAlbedo) {
    Observer observer(device(), plate_in_furnace(lambert({0.25f, 0.5f, 1.0f})));
    for (const double mu : kCosines)
        expect_radiance(plate(observer, mu, 4), {0.25, 0.5, 1.0}, 1e-6);
}

TEST_F(Furnace, LambertBallOfFlatFacetsShowsItsAlbedo) {
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    add(scene, faceted(icosphere(glm::vec3(0.0f), 1.0f, 3)), lambert(glm::vec3(0.5f)));
    Observer observer(device(), scene);
    for (const glm::dvec3 eye : {glm::dvec3(0, 0, 3), glm::dvec3(2, 1, -2), glm::dvec3(0.1, -4, 0.3)}) {
        expect_radiance(observer.look(eye, {0.05, 0.1, 0.07}, 4), 0.5, 1e-6);
    }
}

// Where smooth normals differ by d from those of the facets, light below a facet but above the smooth horizon
// is cut: at most (1 - cos d) / 2 of the whole. Nothing may be gained.
TEST_F(Furnace, SmoothNormalsNeverGain) {
    constexpr int kLevel = 3;
    const double edge = 1.05146222 / (1 << kLevel);  // of an icosahedron of radius 1, halved at each level
    const double lost = 0.5 * (1.0 - std::cos(edge));
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    add(scene, icosphere(glm::vec3(0.0f), 1.0f, kLevel), lambert(glm::vec3(0.5f)));
    Observer observer(device(), scene);
    RenderSettings settings;
    settings.width = settings.height = 32;
    const Image image = observer.picture(look_at({0, 0, 4}, {0, 0, 0}, 0.3), settings, 1024);
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels) {
        EXPECT_LE(pixel.x, 0.5f * (1.0f + static_cast<float>(kRounding)));
        sum += static_cast<double>(pixel.x) / static_cast<double>(image.pixels.size());
    }
    EXPECT_GE(sum, 0.5 * (1.0 - lost));
}

TEST_F(Furnace, MirrorsShowExactlyOne) {
    Scene scene = plate_in_furnace(mirror(), 3.0f);
    add(scene, icosphere({0.0f, 1.2f, 0.0f}, 1.0f, 3), mirror());
    Observer observer(device(), scene);
    RenderSettings settings;
    settings.width = settings.height = 48;
    settings.max_depth = 64;
    const Image image = observer.picture(look_at({0.5, 2.5, 5}, {0, 0.8, 0}), settings, 4);
    for (const glm::vec3& pixel : image.pixels)
        ASSERT_EQ(pixel, glm::vec3(1.0f));
    EXPECT_EQ(observer.counts().truncated, 0u);
    EXPECT_GT(observer.counts().lookups, 4u * 1000u);
}

struct AlbedoRow {
    double alpha;
    std::array<double, 4> albedo;  ///< at kCosines
};

// GGX with height-correlated Smith masking and F = 1: float64 quadrature of the BRDF; the row of alpha = 1 is
// also E(mu) = 1 - mu ln(1 + 1 / mu).
constexpr std::array<AlbedoRow, 5> kGgxAlbedo = {{{0.04, {0.998298, 0.997372, 0.995457, 0.983592}},
                                                  {0.10, {0.988304, 0.981685, 0.969205, 0.921623}},
                                                  {0.25, {0.915812, 0.886244, 0.857263, 0.840082}},
                                                  {0.50, {0.687849, 0.682774, 0.698251, 0.765203}},
                                                  {1.00, {0.306853, 0.376775, 0.450694, 0.597641}}}};

TEST_F(Furnace, GgxMetalShowsItsDirectionalAlbedo) {
    for (const AlbedoRow& row : kGgxAlbedo) {
        Observer observer(device(), plate_in_furnace(glossy_metal(static_cast<float>(std::sqrt(row.alpha)))));
        for (std::size_t i = 0; i < kCosines.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "alpha " << row.alpha << ", cosine " << kCosines[i]);
            const Estimate estimate = plate(observer, kCosines[i], 256);
            expect_radiance(estimate, row.albedo[i]);
            EXPECT_LE(estimate.mean.x, 1.0);
        }
    }
}

// With Schlick's reflectance the albedo is F0 A + B: float64 quadrature, alpha and cosine as given.
TEST_F(Furnace, ReflectanceOfAMetalScalesItsAlbedo) {
    struct Split {
        double alpha, mu, a, b;
    };
    constexpr float kF0 = 0.5f;
    for (const Split& s : {Split{0.1, 0.5, 0.937066, 0.032139}, Split{0.25, 0.5, 0.834916, 0.022347},
                           Split{0.5, 0.5, 0.688101, 0.010150}, Split{1.0, 0.5, 0.447705, 0.002989}}) {
        SCOPED_TRACE(s.alpha);
        const auto roughness = static_cast<float>(std::sqrt(s.alpha));
        Observer observer(device(), plate_in_furnace(glossy_metal(roughness, glm::vec3(kF0))));
        expect_radiance(plate(observer, s.mu, 256), static_cast<double>(kF0) * s.a + s.b);
    }
}

// Glossy lobes above normals that are not the surface's: no more light leaves than comes.
TEST_F(Furnace, GlossyMetalBallNeverGains) {
    for (const double alpha : {0.04, 0.25, 1.0}) {
        SCOPED_TRACE(alpha);
        Scene scene;
        scene.environment = glm::vec3(1.0f);
        add(scene, icosphere(glm::vec3(0.0f), 1.0f, 2), glossy_metal(static_cast<float>(std::sqrt(alpha))));
        Observer observer(device(), scene);
        for (const glm::dvec3 target : {glm::dvec3(0, 0, 0), glm::dvec3(0.6, 0, 0), glm::dvec3(0.9, 0.3, 0),
                                        glm::dvec3(0.3, -0.92, 0)}) {
            const Estimate estimate = observer.look({0, 0, 5}, target, 64);
            EXPECT_LE(estimate.mean.x, 1.0 + kSigmas * estimate.standard_error.x);
        }
    }
}

// A smooth dielectric of F0 = 0.04: Schlick's F is mirrored, (1 - F) of the base colour is not. F = 0.04
// straight on and 0.04 + 0.96 / 32 = 0.07 at 60 degrees.
TEST_F(Furnace, SmoothDielectricSplitsByFresnel) {
    Material material = lambert(glm::vec3(0.5f));
    material.specular = 1.0f;
    material.roughness = 0.0f;
    Observer observer(device(), plate_in_furnace(material));
    expect_radiance(plate(observer, 1.0, 4), 0.04 + 0.96 * 0.5, 1e-6);
    expect_radiance(plate(observer, 0.5, 4), 0.07 + 0.93 * 0.5, 1e-6);
    material.base_colour = glm::vec3(1.0f);
    Observer white(device(), plate_in_furnace(material));
    expect_radiance(plate(white, 0.25, 4), 1.0, 1e-6);
}

// ior 2 gives F0 = 1/9; the weight `specular` scales both ends of Schlick's curve.
TEST_F(Furnace, IndexOfRefractionAndSpecularWeight) {
    Material material = lambert(glm::vec3(0.0f));
    material.roughness = 0.0f;
    material.ior = 2.0f;
    material.specular = 0.5f;
    Observer observer(device(), plate_in_furnace(material));
    // A close-up's width makes Schlick's fifth power vary, by some 1e-5.
    expect_radiance(plate(observer, 1.0, 4), 0.5 / 9.0, 1e-6);
    expect_radiance(plate(observer, 0.5, 4), 0.5 * (1.0 / 9.0 + (8.0 / 9.0) / 32.0), 1e-5);
}

// KHR_materials_specular: straight on the colour scales F0 up to 1, before strength scales all; what lies
// under the dielectric loses the most that some colour is reflected. At 60 degrees Schlick's power is 1 / 32.
TEST_F(Furnace, SpecularColourAndStrength) {
    Material material = lambert(glm::vec3(0.5f));
    material.roughness = 0.0f;
    material.specular = 0.5f;
    material.specular_colour = {0.0f, 5.0f, 1000.0f};
    Observer observer(device(), plate_in_furnace(material));
    const glm::dvec3 normal = 0.5 * glm::dvec3(0.0, 0.2, 1.0);
    expect_radiance(plate(observer, 1.0, 4), normal + 0.5 * (1.0 - 0.5), 1e-6);
    const glm::dvec3 oblique = 0.5 * (glm::dvec3(0.0, 0.2, 1.0) + glm::dvec3(1.0, 0.8, 0.0) / 32.0);
    expect_radiance(plate(observer, 0.5, 4), oblique + 0.5 * (1.0 - 0.5), 1e-5);
}

// The same, scaled by textures: the colour by sRGB values, the strength by an alpha.
TEST_F(Furnace, SpecularTexturesScaleColourAndStrength) {
    Material material = lambert(glm::vec3(0.0f));
    material.roughness = 0.0f;
    material.specular = 1.0f;
    material.specular_texture.texture = 0;
    material.specular_colour = glm::vec3(25.0f);
    material.specular_colour_texture.texture = 1;
    Scene scene = plate_in_furnace(material);
    scene.textures = {{"strength", 1, 1, {0, 0, 0, 51}}, {"colour", 1, 1, {0, 55, 255, 0}}};
    Observer observer(device(), scene);
    // F0 is 0.04 * 25 = 1 times the colour. 51 / 255 = 0.2; 55 is 0.0382044 (IEC 61966-2-1), to six digits.
    expect_radiance(plate(observer, 1.0, 4), 0.2 * glm::dvec3(0.0, 0.0382044, 1.0), 1e-6);
}

// Between dielectric and metal the two are mixed by `metallic`.
TEST_F(Furnace, MetallicMixesDielectricAndMetal) {
    Material material = lambert(glm::vec3(0.5f));
    material.roughness = 0.0f;
    material.specular = 1.0f;
    material.metallic = 0.25f;
    Observer observer(device(), plate_in_furnace(material));
    expect_radiance(plate(observer, 1.0, 4), 0.75 * (0.04 + 0.96 * 0.5) + 0.25 * 0.5, 1e-6);
}

}  // namespace
}  // namespace utsuri::test
