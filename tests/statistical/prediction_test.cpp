// SPDX-License-Identifier: Apache-2.0
// Predicted errors of look-ups hold what rays measure: over scenes, methods and random eyes.
#include "import/conversion/gltf.h"
#include "renderers/methods/method.h"
#include "renderers/methods/raster_renderer.h"
#include "support/coded_room.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "reflector_eyes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kWidth = 96;
constexpr std::uint32_t kHeight = 72;
constexpr std::uint32_t kMapSize = 256;
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

/// Of each pixel.
struct Errors {
    std::vector<PredictedError> predicted;
    std::vector<MeasuredError> measured;
};

void add_view(Tally& tally, const Errors& errors) {
    const auto& [predicted, measured] = errors;
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
    static Errors errors_from(RasterRenderer& renderer, const Camera& eye) {
        renderer.set_camera(eye);
        return {renderer.predict_errors(), renderer.measure_errors()};
    }
    static std::unique_ptr<RasterRenderer> prepared(const SceneData& data, const GpuScene& gpu_scene,
                                                    KeptLight& light, const Camera& first_eye, MapKind kind,
                                                    std::uint32_t most_probes = 1) {
        MapSettings settings;
        settings.most_probes = most_probes;
        settings.size = kMapSize;
        settings.samples = 1;
        settings.predicts_errors = true;
        RenderSettings picture;
        picture.width = kWidth;
        picture.height = kHeight;
        auto renderer = std::make_unique<RasterRenderer>(
            RendererInput{device(), data, gpu_scene, light_methods().front(), light, first_eye},
            RasterMethod{kind}, picture, settings);
        Progress progress;
        renderer->prepare(progress);
        return renderer;
    }

    static void expect_bounds(const Scene& scene, const Trial& trial) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene,
                                     evenly_kept(1.0 / 20.0, 1, 0));  // light does not matter here
        const std::vector<Camera> eyes = eyes_before_reflectors(scene, data, trial.eyes, 1);
        for (const auto& [kind, name] : kKinds) {
            const auto renderer = prepared(data, gpu_scene, light, eyes.front(), kind, trial.most_probes);
            Tally result;
            for (const Camera& eye : eyes)
                add_view(result, errors_from(*renderer, eye));
            EXPECT_GT(result.parallax_pixels, 1000u) << name;
            if (trial.nothing_is_thin) {
                EXPECT_EQ(result.parallax_above, 0u) << name << ", of " << result.parallax_pixels;
            }
            // What is thinner than a texel may have been missed by all rays that measure distances.
            EXPECT_LE(static_cast<double>(result.above), 1e-3 * static_cast<double>(result.pixels)) << name;
            // Distance maps are predicted to be off only where the capture point cannot tell: mostly they are
            // not. What they are predicted where it can is up to PredictedErrorsOfABall.
            if (kind == MapKind::distance) {
                EXPECT_GT(result.trusted.back(), 0u) << name;
            }
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

/// A ball in a room without anything else, seen from in between. Of all that its rays meet the capture point,
/// which is its centre, sees everything; no ray meets the ball again.
struct BallInARoom {
    CodedRoom room{{0, 0, 0}, {4, 3, 4}};
    glm::dvec3 centre{1.8, 1.4, 2.1};
    double radius = 0.5;
    Camera camera = look_at({3.2, 1.9, 3.4}, {1.8, 1.4, 2.1}, 0.6);

    [[nodiscard]] Scene scene() const {
        Scene scene;
        room.add_to(scene);
        add(scene, icosphere(glm::vec3(centre), static_cast<float>(radius), 4), mirror());
        return scene;
    }

    /// What a pixel's centre shows by way of the ball.
    struct Reflection {
        double eye_distance = 0.0;
        double distance = 0.0;          ///< that the mirrored ray goes
        double pixel_angle = 0.0;       ///< of the pixel at the eye
        glm::dvec3 seen{0.0};           ///< where it ends, from the capture point
        double angle_to_an_edge = 0.0;  ///< at the capture point, to where two walls meet
    };
    [[nodiscard]] std::optional<Reflection> reflection(std::uint32_t pixel) const {
        const double scale = 2.0 * std::tan(0.5 * camera.vertical_fov) / kHeight;
        const glm::dvec3 ray =
            glm::normalize(camera.forward + (pixel % kWidth + 0.5 - 0.5 * kWidth) * scale * camera.right -
                           (pixel / kWidth + 0.5 - 0.5 * kHeight) * scale * camera.up);
        const glm::dvec3 to_centre = centre - camera.position;
        const double along = glm::dot(to_centre, ray);
        const double inside = radius * radius - glm::dot(to_centre, to_centre) + along * along;
        // Where the ball is seen more slantwise, the facets of its surface may hide what its normals reflect.
        constexpr double kLeastCosine = 0.2;
        if (inside < kLeastCosine * kLeastCosine * radius * radius) return std::nullopt;
        Reflection result;
        result.eye_distance = along - std::sqrt(inside);
        const glm::dvec3 place = camera.position + result.eye_distance * ray;
        const glm::dvec3 hit = room.wall_point(place, glm::reflect(ray, (place - centre) / radius));
        const double cosine = glm::dot(ray, camera.forward);
        result.distance = glm::distance(place, hit);
        result.pixel_angle = scale * cosine * cosine;
        result.seen = hit - centre;
        result.angle_to_an_edge = angle_to_an_edge(hit);
        return result;
    }

  private:
    /// The least to the planes through the capture point and an edge of the wall.
    [[nodiscard]] double angle_to_an_edge(const glm::dvec3& hit) const {
        const glm::dvec3 lower = room.decode(glm::dvec3(0.0));
        const glm::dvec3 upper = room.decode(glm::dvec3(1.0));
        const glm::dvec3 to_wall = glm::min(hit - lower, upper - hit);
        const int wall = to_wall.x < std::min(to_wall.y, to_wall.z) ? 0 : to_wall.y < to_wall.z ? 1 : 2;
        double least = std::numbers::pi;
        for (int i = 1; i < 3; ++i) {
            glm::dvec3 along(0.0);
            along[(wall + 3 - i) % 3] = 1.0;
            for (const glm::dvec3& corner : {lower, upper}) {
                glm::dvec3 edge = hit;
                edge[(wall + i) % 3] = corner[(wall + i) % 3];
                const glm::dvec3 normal = glm::normalize(glm::cross(edge - centre, along));
                least = std::min(least, std::asin(std::abs(glm::dot(normal, glm::normalize(hit - centre)))));
            }
        }
        return least;
    }
};

class PredictedErrorsOfABall : public PredictedErrors {};

class TracedPixels : public DeviceTest {
  protected:
    struct View {
        std::vector<float> traced;
        std::vector<PredictedError> predicted;
    };
    static View view(MapKind kind, float tolerance) {
        const SceneData data = prepare_scene_data(everything_scene());
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 20.0, 1, 0));
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
        if (predicted.pixels < 0.0f) {
            // Nothing, or a glossy lobe: those are traced.
            ASSERT_TRUE(seen.traced[i] < 0.0f || seen.traced[i] == 1.0f) << "pixel " << i;
            continue;
        }
        ASSERT_GE(seen.traced[i], 0.0f) << "pixel " << i;
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
        const View seen = view(MapKind::hybrid, tolerance);
        for (std::size_t i = 0; i < seen.traced.size(); ++i) {
            if (seen.predicted[i].pixels < 0.0f) continue;
            ++mirrors;
            ASSERT_EQ(seen.traced[i], expected) << "at a tolerance of " << tolerance;
        }
        EXPECT_GT(mirrors, 500u);
    }
}

TEST_F(TracedPixels, AreNotToldByMethodsThatChooseNothing) {
    EXPECT_TRUE(view(MapKind::distance, 1.0f).traced.empty());
}

// Distances tell everything here: on walls, whose inverse depths are affine, to rounding. So the parallax
// that is predicted is that which is measured, whatever the method, and distance maps are trusted.
TEST_F(PredictedErrorsOfABall, AreWhatIsMeasuredWhereDistancesTellAll) {
    constexpr double kTexel = 2.0 / kMapSize;
    // At an edge of the room texels tell less: a block and its surroundings, and those that are interpolated,
    // are four texels; a ray that runs along a wall less than two texels away meets another one as near to
    // their edge.
    constexpr double kFromEdges = 6.0 * kTexel;
    // Rounding of float32 distances, as in distance_map_test.cpp.
    constexpr double kSlack = 1e-3;
    // A ray that cuts a corner of two texels one after the other, of each by less than a tenth, may seem to
    // come out of the wall in between, and be taken to pass behind something.
    constexpr double kCutCorners = 0.1 * 0.1;
    const BallInARoom ball;
    const SceneData data = prepare_scene_data(ball.scene());
    const GpuScene gpu_scene(device(), data);
    KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 20.0, 1, 0));
    for (const auto& [kind, name] : kKinds) {
        SCOPED_TRACE(name);
        const Errors errors = errors_from(*prepared(data, gpu_scene, light, ball.camera, kind), ball.camera);
        std::size_t pixels = 0;
        std::size_t told = 0;
        std::size_t trusted = 0;
        for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
            const auto truth = ball.reflection(i);
            if (!truth || truth->angle_to_an_edge < kFromEdges) continue;
            const PredictedError& predicted = errors.predicted[i];
            const auto parallax = static_cast<double>(predicted.parallax);
            const auto interpolation = static_cast<double>(predicted.interpolation);
            const auto angle = static_cast<double>(errors.measured[i].angle);
            ASSERT_GE(parallax, angle - interpolation - kSlack) << "pixel " << i;
            ++pixels;
            // Rays of neighbouring pixels part by a ball more than by a plane mirror.
            const double width = truth->pixel_angle * (truth->eye_distance + truth->distance);
            const double all =
                angle + 2.0 * interpolation + static_cast<double>(predicted.texel) + 2.0 * kSlack;
            told += parallax <= angle + interpolation + kSlack &&
                            static_cast<double>(predicted.pixels) <= all * glm::length(truth->seen) / width
                        ? 1
                        : 0;
            trusted += predicted.pixels <= kTolerances[2] ? 1 : 0;
        }
        EXPECT_GT(pixels, 1000u);
        const double least = (1.0 - kCutCorners) * static_cast<double>(pixels);
        EXPECT_GE(static_cast<double>(told), least);
        // Half a diagonal of a texel, 0.0055, at 3.5 m, over a pixel of 0.0072 seen by way of 1.5 m and 1 m
        // or more: less than the tolerance of two pixels.
        if (kind == MapKind::distance) {
            EXPECT_GE(static_cast<double>(trusted), least);
        }
    }
}

// One suite for each scene: they take some 20 s each.
class PredictedErrorsAmongEverything : public PredictedErrors {};
TEST_F(PredictedErrorsAmongEverything, AreBounds) {
    expect_bounds(everything_scene(), {});
}

class PredictedErrorsInTheOffice : public PredictedErrors {};
TEST_F(PredictedErrorsInTheOffice, AreBounds) {
    expect_bounds_of("office-lambert");
}

class PredictedErrorsAmongSpheres : public PredictedErrors {};
TEST_F(PredictedErrorsAmongSpheres, AreBounds) {
    expect_bounds_of("spheres");
}

class PredictedErrorsOfACurvedMirror : public PredictedErrors {};
TEST_F(PredictedErrorsOfACurvedMirror, AreBounds) {
    expect_bounds_of("curved-mirror", {5, 1, true, false});
}

class PredictedErrorsOfPlaneMirrors : public PredictedErrors {};
TEST_F(PredictedErrorsOfPlaneMirrors, AreBoundsInTheCornellBox) {
    expect_bounds_of("mirror-cornell", {3, 1});
}
TEST_F(PredictedErrorsOfPlaneMirrors, AreBoundsInACorridor) {
    expect_bounds_of("mirror-corridor", {3, 1, false, false});
}

class PredictedErrorsFromSeveralProbes : public PredictedErrors {};
TEST_F(PredictedErrorsFromSeveralProbes, AreBoundsInAClutteredRoom) {
    expect_bounds_of("cluttered-mirror", {3, 4, false, false});
}

}  // namespace
}  // namespace utsuri::test
