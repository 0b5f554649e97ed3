// SPDX-License-Identifier: Apache-2.0
// What hybrid looks up is as bright as what it traces, give or take the tolerance: over scenes and random
// eyes.
#include "import/conversion/gltf.h"
#include "renderers/methods/raster_renderer.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "reflector_eyes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace utsuri::test {
namespace {

constexpr std::size_t kEyes = 6;
constexpr std::array kTolerances = {0.01, 0.05, 0.20};
/// Of the pixels of mirrors: by what is thinner than a texel, which no ray that bounds radiance met.
constexpr double kBroken = 1e-3;
/// What is looked up in evenly lit maps and what a ray brings may differ by the rounding of some twenty
/// operations on 24 bits.
constexpr double kRounding = 1e-5;
const glm::vec3 kRadiance(3, 2, 1);
/// Traced at a tolerance of a fifth, at most: else there is nothing to trade.
constexpr double kMostTraced = 2.0 / 3.0;

float largest(glm::vec3 v) {
    return std::max({v.x, v.y, v.z});
}

/// Error of a channel relative to the brightest channel of the truth, as Tolerance::Of::radiance has it.
double relative_error(glm::vec3 shown, glm::vec3 truth) {
    const float error = largest(glm::abs(shown - truth));
    return error > 0.0f ? static_cast<double>(error) / static_cast<double>(largest(truth)) : 0.0;
}

/// Mirrors show nothing but what they reflect.
Scene with_black_mirrors(Scene scene) {
    for (Material& material : scene.materials) {
        if (material.roughness == 0.0f && material.metallic == 0.0f) {
            material.base_colour = glm::vec3(0.0f);
            material.emissive = glm::vec3(0.0f);
        }
    }
    return scene;
}

struct Tally {
    std::size_t pixels = 0;  ///< of mirrors
    std::size_t broken = 0;  ///< of those, off by more than the tolerance
    std::uint64_t lookups = 0;
    std::uint64_t traced = 0;

    [[nodiscard]] double traced_share() const {
        return static_cast<double>(traced) / static_cast<double>(lookups);
    }
};

class RadianceTolerance : public DeviceTest {
  protected:
    struct View {
        Image image;
        std::vector<PredictedError> predicted;  ///< tells the pixels of mirrors
    };
    struct Views {
        std::vector<View> views;
        FrameCounts counts;
    };

    /// A sample at the centre of each pixel, with the same light whatever the tolerance.
    static Views draw(const SceneData& data, const GpuScene& gpu_scene, KeptLight& light,
                      const std::vector<Camera>& eyes, Tolerance tolerance) {
        MapSettings settings;
        settings.size = 128;
        settings.samples = 4;
        settings.tolerance = tolerance;
        RenderSettings picture;
        picture.width = 96;
        picture.height = 72;
        RasterRenderer renderer =
            make_raster(device(), data, gpu_scene, light, eyes.front(), MapKind::hybrid, picture, settings);
        Progress progress;
        renderer.prepare(progress);
        Views result;
        for (const Camera& eye : eyes) {
            renderer.set_camera(eye);
            renderer.draw_frame();
            result.views.push_back({renderer.frame(), renderer.predict_errors()});
            Film film(device(), picture.width, picture.height, "traced share");
            renderer.add_samples(film, 1, progress);
        }
        result.counts = renderer.statistics().counts;
        return result;
    }

    static Tally compare(const Views& shown, const Views& truth, double tolerance) {
        Tally tally;
        for (std::size_t v = 0; v < truth.views.size(); ++v) {
            const View& view = truth.views[v];
            for (std::size_t i = 0; i < view.predicted.size(); ++i) {
                if (view.predicted[i].parallax < 0.0f) continue;
                ++tally.pixels;
                const double error = relative_error(shown.views[v].image.pixels[i], view.image.pixels[i]);
                tally.broken += error <= tolerance + kRounding ? 0 : 1;
            }
        }
        tally.lookups = shown.counts.lookups;
        tally.traced = shown.counts.traced;
        return tally;
    }

    static void expect_tolerances_hold(const Scene& original) {
        const Scene scene = with_black_mirrors(original);
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 60.0, 4, 0));
        const std::vector<Camera> eyes = eyes_before_reflectors(scene, data, kEyes, 1);
        const Views truth = draw(data, gpu_scene, light, eyes, {Tolerance::Of::place, 0.0});
        EXPECT_EQ(truth.counts.traced, truth.counts.lookups);
        double more_traced = 1.0;
        for (const double tolerance : kTolerances) {
            const Views shown = draw(data, gpu_scene, light, eyes, {Tolerance::Of::radiance, tolerance});
            const Tally tally = compare(shown, truth, tolerance);
            EXPECT_GT(tally.pixels, 1000u);
            EXPECT_LE(static_cast<double>(tally.broken), kBroken * static_cast<double>(tally.pixels))
                << "at " << tolerance << ", of " << tally.pixels;
            EXPECT_LE(tally.traced_share(), more_traced) << "at " << tolerance;
            more_traced = tally.traced_share();
            const auto percent = static_cast<int>(std::lround(100.0 * tolerance));
            RecordProperty("traced at " + std::to_string(percent) + "%", std::to_string(more_traced));
            RecordProperty("broken at " + std::to_string(percent) + "%", std::to_string(tally.broken));
        }
        EXPECT_LT(more_traced, kMostTraced);
    }
    /// A room as bright everywhere, with a mirror in it.
    static Scene even_room() {
        Scene scene;
        add(scene, room({0, 0, 0}, {4, 3, 5}), emitter(kRadiance));
        add(scene, quad({1, 1, 1}, {2, 0, 0}, {0, 1, 0}), mirror());
        return scene;
    }
    /// Of the pixels of the mirror of even_room().
    static double traced_share(const Scene& scene, double tolerance) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 20.0, 4, 0));
        const FrameCounts counts = draw(data, gpu_scene, light, {look_at({1, 2.8, 4}, {2, 1.5, 1}, 0.6)},
                                        {Tolerance::Of::radiance, tolerance})
                                       .counts;
        EXPECT_GT(counts.lookups, 1000u);
        return static_cast<double>(counts.traced) / static_cast<double>(counts.lookups);
    }
    static Scene scene_file(const std::string& name) {
        const auto path = std::filesystem::path(UTSURI_SOURCE_DIR) / "scenes" / name / (name + ".glb");
        return import_gltf(path).scene;
    }
};

// The mirror's front sees all of the room, and so does its capture point. Only along creases between walls,
// within a texel, the search may not be sure.
TEST_F(RadianceTolerance, EvenlyBrightSurroundingsAreNotTraced) {
    EXPECT_LE(traced_share(even_room(), kLeastRadianceTolerance), 0.01);
}

// Behind a panel the room may have any radiance, though it has none but that of the rest of it. The eye,
// above the capture point, sees a strip of that in the mirror.
TEST_F(RadianceTolerance, WhatTheCapturePointCannotSeeIsTraced) {
    Scene scene = even_room();
    Material panel = emitter(kRadiance);
    panel.double_sided = true;
    add(scene, quad({1.5f, 1, 2.5f}, {1, 0, 0}, {0, 1, 0}), panel);
    const double share = traced_share(scene, 0.5);
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.9);
}

// A poster on the wall that the mirror shows: diffuse, it is looked up; with a gloss, be it weak, it is
// traced.
TEST_F(RadianceTolerance, GlossyLobesAreTraced) {
    const auto share_with = [](float specular) {
        Scene scene = even_room();
        Material poster = lambert(glm::vec3(0.8f));
        poster.roughness = 0.8f;
        poster.specular = specular;
        add(scene, quad({0.5f, 0.5f, 4.99f}, {0, 2, 0}, {3, 0, 0}), poster);
        return traced_share(scene, 0.5);
    };
    const double diffuse = share_with(0.0f);
    EXPECT_GT(share_with(1.0f), diffuse + 0.1);
}

// One suite for each scene: they take some 20 s each.
class RadianceToleranceAmongEverything : public RadianceTolerance {};
TEST_F(RadianceToleranceAmongEverything, Holds) {
    expect_tolerances_hold(everything_scene());
}

class RadianceToleranceInTheOffice : public RadianceTolerance {};
TEST_F(RadianceToleranceInTheOffice, Holds) {
    expect_tolerances_hold(scene_file("office-lambert"));
}

class RadianceToleranceAmongSpheres : public RadianceTolerance {};
TEST_F(RadianceToleranceAmongSpheres, Holds) {
    expect_tolerances_hold(scene_file("spheres"));
}

}  // namespace
}  // namespace utsuri::test
