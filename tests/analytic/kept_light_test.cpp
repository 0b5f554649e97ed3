// SPDX-License-Identifier: Apache-2.0
// Traced pictures lit from the light kept on surfaces: --kept-light.
#include "renderers/light/lobe_albedo.h"
#include "renderers/methods/method.h"
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "image/metrics.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSamples = 16;
/// So coarse that what is kept differs visibly from what is simulated at each hit.
constexpr LightSettings kCoarse = evenly_kept(1.0 / 5.0, 4, 0);

RenderSettings picture_of(std::uint32_t size, bool kept_light) {
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.kept_light = kept_light;
    return settings;
}

/// Off all axes, so that every coordinate is rounded.
const glm::dmat4 kSlanted =
    glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3.3, -1.7, 2.2)), 0.7, glm::dvec3(1, 2, 3));

/// Of the table of albedos, between its entries: lobe_albedo_test.cpp.
constexpr double kTable = 5e-3;

class KeptLightTraced : public DeviceTest {
  protected:
    struct Pictures {
        Image whole;
        Image half;
        RenderStatistics statistics;
    };

    static Pictures render(const Scene& scene, const Camera& camera, const char* reflection,
                           const RenderSettings& settings, std::uint32_t samples = kSamples,
                           const MapSettings& maps = {}, const LightSettings& light_settings = kCoarse) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, light_settings);
        const Method method = find_method("direct", reflection);
        const std::unique_ptr<Renderer> renderer =
            make_renderer(method, {device(), data, gpu_scene, *method.light, light, camera}, settings, maps);
        Film film(device(), settings.width, settings.height, "film");
        Progress silent;
        renderer->prepare(silent);
        renderer->add_samples(film, samples, silent);
        return {film.resolve(), film.resolve_half(0), renderer->statistics()};
    }
};

/// A room with a block on its floor, lit by a panel: all of it matt.
Scene matt_room() {
    Scene scene;
    add(scene, room({-2, 0, -2}, {2, 3, 2}), lambert({0.7f, 0.6f, 0.5f}));
    add(scene, room({-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}), lambert({0.2f, 0.5f, 0.8f}));
    add(scene, ceiling({0, 2.9f, 0}, 0.5f), emitter(glm::vec3(20)));
    return scene;
}

/// A tent of four walls and a roof without thickness, on ground that goes on outside in the sun at noon;
/// turned off all axes.
Scene tent() {
    Scene scene;
    add(scene, ground(4.0f), lambert(glm::vec3(0.5f)));
    for (const Mesh& wall : {quad({-1, 0, -1}, {2, 0, 0}, {0, 2, 0}), quad({1, 0, -1}, {0, 0, 2}, {0, 2, 0}),
                             quad({1, 0, 1}, {-2, 0, 0}, {0, 2, 0}), quad({-1, 0, 1}, {0, 0, -2}, {0, 2, 0}),
                             quad({-1, 2, -1}, {2, 0, 0}, {0, 0, 2})})
        add(scene, wall, lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = glm::dvec3(kSlanted * glm::dvec4(0, -1, 0, 0));
    sun.intensity = glm::vec3(1.0f);
    scene.lights.push_back(sun);
    for (Instance& instance : scene.instances)
        instance.world_from_object = kSlanted;
    return scene;
}

// Not even where an edge is drawn a rounding off: along 500 pixels of the line between a wall and the ground,
// with 16 samples each, some lie on the line by the 1/256 of a pixel that corners are moved.
TEST_F(KeptLightTraced, ShowsNoLightThatIsBehindAWall) {
    const auto turned = [](const glm::dvec3& p) { return glm::dvec3(kSlanted * glm::dvec4(p, 1.0)); };
    for (const glm::dvec3& target : {glm::dvec3(-0.2, 0, -1), glm::dvec3(1, 0, 0.1), glm::dvec3(0.7, 0, 1)}) {
        const Camera camera = look_at(turned({0.1, 1.2, 0.2}), turned(target), 1.4);
        const Pictures pictures = render(tent(), camera, "cube-map", picture_of(512, true));
        for (const glm::vec3& pixel : pictures.whole.pixels)
            ASSERT_EQ(pixel, glm::vec3(0.0f));
    }
}

// Both estimate the same picture, each with the noise of where its samples lie in their pixels. The picture
// of half the samples is off the whole by as much as the whole is off the truth, in the mean square; two such
// errors add up to twice that, and twice as much again is left to the estimate itself.
TEST_F(KeptLightTraced, ShowsWhatDrawnSurfacesShow) {
    const Camera camera = look_at({1.5, 2.2, 1.8}, {0, 0.8, 0}, 1.0);
    const Pictures traced = render(matt_room(), camera, "trace", picture_of(64, true));
    const Pictures drawn = render(matt_room(), camera, "cube-map", picture_of(64, true));
    const Pictures simulated = render(matt_room(), camera, "trace", picture_of(64, false), 256);
    const double noise = compute_metrics(traced.whole, traced.half, nullptr, nullptr).rel_mse;
    const double apart = compute_metrics(traced.whole, drawn.whole, nullptr, nullptr).rel_mse;
    EXPECT_LE(apart, 4.0 * noise);
    EXPECT_GT(compute_metrics(simulated.whole, drawn.whole, nullptr, nullptr).rel_mse, 8.0 * noise)
        << "the light kept is too fine to be told from simulated light";
}

// A varnished floor in the sun, a panel above its middle. Light is kept at the corners of the floor alone,
// which are lit: so the middle is, too, where kept light is asked, and black where it is simulated. The eye
// sees it in a mirror. The varnish lets through what the table tells.
TEST_F(KeptLightTraced, IsSeenInMirrorsUnderGlossyLobes) {
    constexpr double kIlluminance = 10.0;
    Material varnished = lambert(glm::vec3(0.5f));
    varnished.specular = 1.0f;
    varnished.roughness = 0.5f;
    Scene scene;
    add(scene, ground(2.0f), varnished);
    add(scene, ceiling({0, 1, 0}, 0.5f), lambert(glm::vec3(0.0f)));
    add(scene, quad({-2, 0, -2}, {4, 0, 0}, {0, 1, 0}), mirror());
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0, -1, 0};
    sun.intensity = glm::vec3(static_cast<float>(kIlluminance));
    scene.lights.push_back(sun);
    const glm::dvec3 eye(0, 0.6, 1.8);
    const glm::dvec3 middle_in_mirror(0, 0, -4);
    const Camera camera = look_at(eye, middle_in_mirror, 1e-3);
    const glm::dvec3 way = eye - middle_in_mirror;
    const double lost = static_cast<double>(lobe_albedo(0.25, way.y / glm::length(way)).lost);
    const double expected = 0.5 * (1.0 - glm::mix(0.04, 1.0, lost)) * kIlluminance / std::numbers::pi;
    constexpr LightSettings kCorners = evenly_kept(1.0, 16, 0);
    MapSettings rays;  // no mirrored view, and no lookup of what has a glossy lobe
    rays.tolerance = {Tolerance::Of::radiance, kLeastRadianceTolerance};
    const auto shown = [&](const char* reflection, bool kept) {
        const Pictures pictures = render(scene, camera, reflection, picture_of(1, kept), 2, rays, kCorners);
        return static_cast<double>(pictures.whole.pixels.front().y);
    };
    EXPECT_NEAR(shown("trace", true), expected, kTable * expected);
    EXPECT_NEAR(shown("hybrid", false), expected, kTable * expected);
    EXPECT_EQ(shown("trace", false), 0.0);
}

TEST_F(KeptLightTraced, TakesNoShadowRaysOnMattSurfaces) {
    const Camera camera = look_at({1.5, 2.2, 1.8}, {0, 0.8, 0}, 1.0);
    const Pictures traced = render(matt_room(), camera, "trace", picture_of(32, true));
    EXPECT_EQ(traced.statistics.counts.rays, 32u * 32u * kSamples);
    EXPECT_GT(traced.statistics.prepare_counts.rays, 0u);
}

// Under a uniform environment of radiance 1 a pixel tells the albedo of all lobes. Kept light leaves by the
// mean share that the glossy lobe lets through, which is exact there: it is the mean over a Lambert lobe of
// uniform light.
TEST_F(KeptLightTraced, HasTheAlbedoOfGlossySurfaces) {
    for (const float roughness : {0.2f, 0.6f, 1.0f}) {
        for (const double height : {0.3, 3.0}) {
            Scene scene;
            scene.environment = glm::vec3(1.0f);
            Material plastic = lambert(glm::vec3(0.8f));
            plastic.specular = 1.0f;
            plastic.specular_colour = {0.0f, 1.0f, 20.0f};
            plastic.roughness = roughness;
            add(scene, ground(1000.0f), plastic);
            const Camera camera = look_at({0, height, 1}, {0, 0, 0}, 0.01);
            constexpr std::uint32_t kMany = 256;
            const auto look = [&](bool kept) {
                return estimate_of(render(scene, camera, "trace", picture_of(16, kept), kMany).whole);
            };
            const Estimate kept = look(true);
            const Estimate simulated = look(false);
            for (int c = 0; c < 3; ++c) {
                const double error = std::hypot(kept.standard_error[c], simulated.standard_error[c]);
                EXPECT_NEAR(kept.mean[c], simulated.mean[c], kSigmas * error + kTable)
                    << "roughness " << roughness << ", eye at " << height << ", channel " << c;
            }
        }
    }
}

}  // namespace
}  // namespace utsuri::test
