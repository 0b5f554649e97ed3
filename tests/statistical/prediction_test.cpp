// SPDX-License-Identifier: Apache-2.0
// Predicted errors of look-ups hold what rays measure: over scenes, methods and random eyes.
#include "import/gltf.h"
#include "renderers/methods/raster_renderer.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "reflector_eyes.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kWidth = 96;
constexpr std::uint32_t kHeight = 72;
/// Eyes and probes of a reflector.
struct Trial {
    std::size_t eyes = 5;
    std::uint32_t most_probes = 1;
    /// Whether nothing is thinner than a texel that the capture point sees: no ray that measures distances
    /// may have met that.
    bool nothing_is_thin = true;
    /// Whether predictions are tight: not where most rays may meet the reflector or another mirror, of which
    /// distances tell nothing.
    bool is_tight = true;
};

/// Of hybrid, in pixels.
constexpr std::array kTolerances = {0.5f, 1.0f, 2.0f, 4.0f};

struct Tally {
    std::size_t pixels = 0;
    std::size_t parallax_pixels = 0;  ///< the capture point sees what the ray meets
    std::size_t parallax_above = 0;   ///< of those, measured above predicted
    std::size_t above = 0;
    std::array<std::size_t, kTolerances.size()> trusted{};  ///< pixels that hybrid would look up
    std::array<std::size_t, kTolerances.size()> broken{};   ///< of those, off by more than the tolerance
    std::vector<double> ratios;  ///< measured over predicted, where that is more than a texel

    double median() {
        if (ratios.empty()) return 0.0;
        const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        return *middle;
    }
};

void add_view(Tally& tally, const std::vector<PredictedError>& predicted,
              const std::vector<MeasuredError>& measured) {
    ASSERT_EQ(predicted.size(), measured.size());
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (predicted[i].parallax < 0.0f) continue;
        const double bound =
            static_cast<double>(predicted[i].parallax + predicted[i].interpolation + predicted[i].texel);
        const auto angle = static_cast<double>(measured[i].angle);
        const bool above = angle > bound;
        ++tally.pixels;
        tally.above += above ? 1 : 0;
        if (measured[i].seen > 0.0f) {
            ++tally.parallax_pixels;
            tally.parallax_above += above ? 1 : 0;
        }
        for (std::size_t k = 0; k < kTolerances.size(); ++k) {
            if (predicted[i].pixels > kTolerances[k]) continue;
            ++tally.trusted[k];
            tally.broken[k] += measured[i].pixels > kTolerances[k] ? 1 : 0;
        }
        if (bound > 2.0 * static_cast<double>(predicted[i].texel)) tally.ratios.push_back(angle / bound);
    }
}

constexpr std::array kKinds = {std::pair{MapKind::polygon, "polygon"}, std::pair{MapKind::sphere, "sphere"},
                               std::pair{MapKind::cube, "cube"}, std::pair{MapKind::proxy, "proxy"},
                               std::pair{MapKind::distance, "distance"}};

class PredictedErrors : public DeviceTest {
  protected:
    static Tally tally(const SceneData& data, const GpuScene& gpu_scene, KeptLight& light,
                       const std::vector<Camera>& eyes, MapKind kind, std::uint32_t most_probes) {
        MapSettings settings;
        settings.most_probes = most_probes;
        settings.size = 256;
        settings.samples = 1;
        settings.predicts_errors = true;
        RenderSettings picture;
        picture.width = kWidth;
        picture.height = kHeight;
        RasterRenderer renderer =
            make_raster(device(), data, gpu_scene, light, eyes.front(), kind, picture, settings);
        Progress progress;
        renderer.prepare(progress);
        Tally result;
        for (const Camera& eye : eyes) {
            renderer.set_camera(eye);
            add_view(result, renderer.predict_errors(), renderer.measure_errors());
        }
        return result;
    }

    static void expect_bounds(const Scene& scene, const Trial& trial) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light =
            kept_light(device(), data, gpu_scene, {1.0 / 20.0, 1, 0});  // light does not matter here
        const std::vector<Camera> eyes = eyes_before_reflectors(scene, data, trial.eyes, 1);
        for (const auto& [kind, name] : kKinds) {
            Tally result = tally(data, gpu_scene, light, eyes, kind, trial.most_probes);
            EXPECT_GT(result.parallax_pixels, 1000u) << name;
            if (trial.nothing_is_thin) {
                EXPECT_EQ(result.parallax_above, 0u) << name << ", of " << result.parallax_pixels;
            }
            // What is thinner than a texel may have been missed by all rays that measure distances.
            EXPECT_LE(static_cast<double>(result.above), 1e-3 * static_cast<double>(result.pixels)) << name;
            // Distance maps are predicted to be off only where the capture point cannot tell: mostly they are
            // not.
            for (std::size_t k = 0; k < kTolerances.size(); ++k) {
                EXPECT_LE(static_cast<double>(result.broken[k]), 1e-3 * static_cast<double>(result.pixels))
                    << name << " at " << kTolerances[k] << " pixels";
            }
            if (kind != MapKind::distance && trial.is_tight) {
                EXPECT_GT(result.median(), 0.5) << name;
            }
        }
    }
    static void expect_bounds_of(const std::string& name, const Trial& trial = {}) {
        const auto path = std::filesystem::path(UTSURI_SOURCE_DIR) / "scenes" / name / (name + ".glb");
        expect_bounds(import_gltf(path).scene, trial);
    }
};

class TracedPixels : public DeviceTest {
  protected:
    struct View {
        std::vector<float> traced;
        std::vector<PredictedError> predicted;
    };
    static View view(MapKind kind, float tolerance) {
        const SceneData data = prepare_scene_data(everything_scene());
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, {1.0 / 20.0, 1, 0});
        MapSettings settings;
        settings.size = 64;
        settings.samples = 1;
        settings.tolerance = {Tolerance::Of::place, tolerance};
        settings.predicts_errors = true;
        RenderSettings picture;
        picture.width = kWidth;
        picture.height = kHeight;
        RasterRenderer renderer =
            make_raster(device(), data, gpu_scene, light, everything_camera(), kind, picture, settings);
        Progress progress;
        renderer.prepare(progress);
        return {renderer.traced_pixels(), renderer.predict_errors()};
    }
};

TEST_F(TracedPixels, AreThosePredictedToBeOffByMoreThanTheTolerance) {
    constexpr float kTolerance = 2.0f;
    const View seen = view(MapKind::hybrid, kTolerance);
    ASSERT_EQ(seen.traced.size(), std::size_t{kWidth} * kHeight);
    std::size_t mirrors = 0;
    std::size_t traced = 0;
    std::size_t others = 0;
    for (std::size_t i = 0; i < seen.traced.size(); ++i) {
        const PredictedError& predicted = seen.predicted[i];
        ASSERT_EQ(seen.traced[i] < 0.0f, predicted.pixels < 0.0f) << "pixel " << i;
        if (predicted.pixels < 0.0f) continue;
        ++mirrors;
        traced += seen.traced[i] == 1.0f ? 1 : 0;
        others += (seen.traced[i] == 1.0f) != (predicted.pixels > kTolerance) ? 1 : 0;
    }
    EXPECT_GT(traced, mirrors / 10);
    EXPECT_LT(traced, mirrors - mirrors / 10);
    // Two shaders may round the prediction of a pixel apart: by some 2^-20, and predictions are spread over
    // decades.
    EXPECT_LE(others, 1u);
}

TEST_F(TracedPixels, AreAllOrNoneAtTheEndsOfTheTolerance) {
    for (const auto& [tolerance, expected] :
         {std::pair{0.0f, 1.0f}, std::pair{std::numeric_limits<float>::infinity(), 0.0f}}) {
        std::size_t mirrors = 0;
        for (const float traced : view(MapKind::hybrid, tolerance).traced) {
            if (traced < 0.0f) continue;
            ++mirrors;
            ASSERT_EQ(traced, expected) << "at a tolerance of " << tolerance;
        }
        EXPECT_GT(mirrors, 500u);
    }
}

TEST_F(TracedPixels, AreNotToldByMethodsThatChooseNothing) {
    EXPECT_TRUE(view(MapKind::distance, 1.0f).traced.empty());
}

TEST_F(PredictedErrors, Everything) {
    expect_bounds(everything_scene(), {});
}
TEST_F(PredictedErrors, Office) {
    expect_bounds_of("office");
}
TEST_F(PredictedErrors, Spheres) {
    expect_bounds_of("spheres");
}
class PredictedErrorsOfRooms : public PredictedErrors {};

TEST_F(PredictedErrorsOfRooms, CurvedMirror) {
    expect_bounds_of("curved-mirror", {5, 1, true, false});
}
TEST_F(PredictedErrorsOfRooms, MirrorCornell) {
    expect_bounds_of("mirror-cornell", {3, 1});
}
TEST_F(PredictedErrorsOfRooms, MirrorCorridor) {
    expect_bounds_of("mirror-corridor", {3, 1, false, false});
}
TEST_F(PredictedErrorsOfRooms, ClutteredMirrorFromSeveralProbes) {
    expect_bounds_of("cluttered-mirror", {3, 4, false, false});
}

}  // namespace
}  // namespace utsuri::test
