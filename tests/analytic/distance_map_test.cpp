// SPDX-License-Identifier: Apache-2.0
// direct/distance-map, the distances it searches, and predictions of errors, in the worked room.
#include "renderers/reflection/distances/distance_maps.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"
#include "support/worked_room.h"

#include "geometry/reference_intersection.h"

#include "map_observer.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSize = 128;
/// Texels of 2 / N rad at the centre of a face, looked at to a quarter, as in polygon_map_test.cpp.
constexpr double kTexel = 0.25 * 2.0 / kSize;

/// Of the infinite map at the worked points, degrees: sin e = |r x (p - c)| / |q - c|.
constexpr std::array<double, 4> kInfiniteErrors = {34.8143228, 12.5757808, 26.4533641, 73.2946167};
/// What predictions of a worked point may be off by, radians: two texels where a wall ends within two, else
/// rounding.
constexpr std::array<double, 4> kSlack = {1e-3, 1e-3, 1e-3, 4.0 / kSize};

/// The same with a box against the wall that the mirror faces.
Scene furnished_room() {
    Scene scene = worked_room();
    add(scene, block({1.5f, 0, 4.0f}, {3.0f, 1.2f, 4.999f}), emitter({2.0f, 0.5f, 1.5f}));
    return scene;
}

class DistanceMap : public DeviceTest {
  protected:
    /// Errors at one pixel whose centre is aimed at a point of the mirror.
    struct Errors {
        PredictedError predicted;
        MeasuredError measured;
    };
    static Errors errors_at(const Scene& scene, MapKind kind, const glm::dvec3& target) {
        return errors_at(scene, kind, map_settings(kSize, kWorkedCapturePoint), kWorkedEye, target);
    }
    static Errors errors_at(const Scene& scene, MapKind kind, MapSettings settings, const glm::dvec3& eye,
                            const glm::dvec3& target) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 20.0, 1, 0));
        settings.samples = 1;
        settings.predicts_errors = true;
        RenderSettings picture;
        picture.width = picture.height = 1;
        RasterRenderer renderer = make_raster(device(), data, gpu_scene, light, look_at(eye, target, 1e-3),
                                              kind, picture, settings);
        Progress progress;
        renderer.prepare(progress);
        return {renderer.predict_errors().front(), renderer.measure_errors().front()};
    }
};

// The room's walls are planes: interpolating their inverse depths is exact, whatever the texels.
TEST_F(DistanceMap, ShowsTheTrueHitsInAnEmptyRoom) {
    MapObserver observer(device(), worked_room(), MapKind::distance,
                         map_settings(kSize, kWorkedCapturePoint));
    for (const WorkedPoint& point : kWorkedPoints) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point.mirror, 4).mean);
        EXPECT_LE(angle_between(seen - kWorkedCapturePoint, point.hit - kWorkedCapturePoint), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
}

TEST_F(DistanceMap, ShowsFurnitureWhereItIs) {
    Scene scene = worked_room();
    add(scene, quad({2.4f, 0.8f, 3.3f}, {0, 1.2f, 0}, {1.2f, 0, 0}), emitter({2.0f, 0.5f, 1.5f}));
    RenderSettings picture;
    picture.width = 96;
    picture.height = 72;
    const Camera camera = look_at(kWorkedEye, {2.2, 1.0, 0}, 0.9);
    const Image truth = trace(device(), scene, camera, picture, 16).image;
    /// Share of the pixels whose truth the capture point sees that show something else.
    const auto wrong_share = [&](MapKind kind) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 20.0, 1, 0));
        MapSettings settings = map_settings(kSize, kWorkedCapturePoint);
        settings.predicts_errors = true;
        RasterRenderer renderer =
            make_raster(device(), data, gpu_scene, light, camera, kind, picture, settings);
        Film film(device(), picture.width, picture.height, "furnished room");
        Progress progress;
        renderer.prepare(progress);
        renderer.add_samples(film, 16, progress);
        const Image image = film.resolve();
        const std::vector<MeasuredError> measured = renderer.measure_errors();
        std::size_t wrong = 0;
        std::size_t seen = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            if (measured[i].seen != 1.0f) continue;
            ++seen;
            wrong += glm::length(image.pixels[i] - truth.pixels[i]) > 0.2f ? 1 : 0;
        }
        return static_cast<double>(wrong) / static_cast<double>(seen);
    };
    // The panel's outline, some hundred pixels long, may be off by a texel, half a pixel here.
    const double outline = 100.0 / (96.0 * 72.0);
    EXPECT_LE(wrong_share(MapKind::distance), outline);
    EXPECT_GE(wrong_share(MapKind::proxy), 1.5 * outline);
}

TEST_F(DistanceMap, ErrorsOfTheInfiniteMapAreThoseOfItsTheory) {
    for (std::size_t i = 0; i < kWorkedPoints.size(); ++i) {
        const WorkedPoint& point = kWorkedPoints[i];
        const Errors errors = errors_at(worked_room(), MapKind::cube, point.mirror);
        const double expected = kInfiniteErrors[i] * std::numbers::pi / 180.0;
        // The eye's direction is float32; predictions see walls through texels, exactly but for rounding.
        EXPECT_NEAR(static_cast<double>(errors.measured.angle), expected, 1e-5);
        EXPECT_NEAR(static_cast<double>(errors.predicted.parallax), expected, kSlack[i]);
        EXPECT_GE(errors.predicted.parallax + errors.predicted.texel, errors.measured.angle);
        EXPECT_EQ(errors.measured.seen, 1.0f);
        EXPECT_NEAR(static_cast<double>(errors.measured.distance), glm::distance(point.hit, point.mirror),
                    1e-4);
    }
}

// B5: a plane mirror puts what is seen at angle e from the capture point by D e / ((l + t) w) pixels off.
TEST_F(DistanceMap, AnglesBecomePixelsByTheWayTheLightGoes) {
    const WorkedPoint& point = kWorkedPoints[1];
    const Errors errors = errors_at(worked_room(), MapKind::cube, point.mirror);
    const double way = glm::distance(kWorkedEye, point.mirror) + glm::distance(point.mirror, point.hit);
    const double pixel = 2.0 * std::tan(0.5e-3);
    const double expected = static_cast<double>(errors.measured.angle) *
                            glm::distance(point.hit, kWorkedCapturePoint) / (way * pixel);
    EXPECT_NEAR(static_cast<double>(errors.measured.pixels), expected, 1e-4 * expected);
}

TEST_F(DistanceMap, ProxyIsPredictedToBeRightWhereItIs) {
    for (std::size_t i = 0; i < kWorkedPoints.size(); ++i) {
        const Errors errors = errors_at(worked_room(), MapKind::proxy, kWorkedPoints[i].mirror);
        EXPECT_LE(errors.measured.angle, 1e-5f);
        EXPECT_LE(static_cast<double>(errors.predicted.parallax), kSlack[i]);
    }
}

TEST_F(DistanceMap, PlanesArePredictedToBeRightWhereTheyAre) {
    for (std::size_t i = 0; i < kWorkedPoints.size(); ++i) {
        const Errors errors =
            errors_at(turned_worked_room(), MapKind::proxy,
                      map_settings(kSize, turned(kWorkedCapturePoint, kWorkedTurn)),
                      turned(kWorkedEye, kWorkedTurn), turned(kWorkedPoints[i].mirror, kWorkedTurn));
        EXPECT_LE(errors.measured.angle, 1e-5f);
        EXPECT_GE(errors.predicted.parallax + errors.predicted.texel, errors.measured.angle);
    }
    const HexagonalHall hall;
    for (const glm::dvec3& point : hall.mirror_points) {
        const Errors errors =
            errors_at(hall.scene(), MapKind::proxy, map_settings(kSize, hall.capture_point), hall.eye, point);
        EXPECT_LE(errors.measured.angle, 1e-5f);
        EXPECT_LE(errors.predicted.parallax, 1e-3f);
        EXPECT_GE(errors.predicted.parallax + errors.predicted.texel, errors.measured.angle);
    }
}

// A room given with its sides and its floor where they are not.
TEST_F(DistanceMap, PlanesArePredictedToBeWrongWhereTheyAreNot) {
    const HexagonalHall hall;
    MapSettings settings = map_settings(kSize, hall.capture_point);
    settings.proxy = GivenProxy{"wrong.txt", hexagonal_room({1, 0, -0.5}, 2.0, 2.8, 0.5).planes()};
    settings.proxy->planes[6].offset = 0.5;
    for (const glm::dvec3& point : hall.mirror_points) {
        const Errors errors = errors_at(hall.scene(), MapKind::proxy, settings, hall.eye, point);
        EXPECT_GE(errors.measured.angle, 1e-2f);
        EXPECT_GE(errors.predicted.parallax + errors.predicted.texel, errors.measured.angle);
    }
}

// The box hides the wall behind it from the capture point; the mirror's lower corners see it.
TEST_F(DistanceMap, WhatIsHiddenIsPredictedAsUnknown) {
    Scene scene = worked_room();
    add(scene, quad({1.0f, 0.5f, 4.0f}, {2.0f, 0, 0}, {0, 2.0f, 0}), emitter({2.0f, 0.5f, 1.5f}));
    bool found = false;
    for (int i = 0; i <= 20; ++i) {
        const Errors errors = errors_at(scene, MapKind::distance, {0.1 + 0.19 * i, 1.5, 0});
        if (errors.measured.seen > 0.0f) continue;
        found = true;
        EXPECT_GE(errors.predicted.parallax + errors.predicted.texel, errors.measured.angle);
        EXPECT_GT(errors.predicted.parallax, 0.1f);
    }
    EXPECT_TRUE(found);
}

TEST_F(DistanceMap, DistancesAreThoseOfTheSceneAndBoundsHoldThem) {
    const Scene scene = furnished_room();
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    const MapSettings settings = map_settings(16, kWorkedCapturePoint);
    std::vector<interop::ProxyPlane> planes;
    const ReflectionMaps maps(device(), data, MapKind::distance, settings, MapView(), planes);
    DistanceMaps distances(device(), data, maps.probe_instances(), maps.infos(), 16);
    Progress progress;
    double seconds = 0.0;
    distances.capture(gpu_scene, seconds, progress);
    const std::uint32_t stride = 16 + 2 * interop::DISTANCE_BORDER;
    const glm::dvec3 point = kWorkedCapturePoint - data.origin;
    const std::uint32_t reflector = maps.reflectors().instances.front();
    // Face +x: u is y, v is z.
    const auto samples = distances.samples(0, 0);
    ASSERT_EQ(samples.size(), stride * stride);
    for (std::uint32_t y = 0; y < stride; ++y) {
        for (std::uint32_t x = 0; x < stride; ++x) {
            const glm::dvec3 direction(1.0, (2.0 * x - 1.0) / 16 - 1.0, (2.0 * y - 1.0) / 16 - 1.0);
            const auto hit = closest_hit_reference(data.bvh, point, direction, 100.0, [&](std::uint32_t t) {
                return data.triangle_infos[t].instance != reflector;
            });
            ASSERT_TRUE(hit || direction.z < 0.0);
            // The mirror is the wall z = 0: what is seen through it can never be mirrored.
            if (!hit) continue;
            const double expected = hit->t * glm::length(direction);
            EXPECT_NEAR(static_cast<double>(samples[y * stride + x].centre), expected, 1e-5 * expected);
        }
    }
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = 0.0f;
    for (const interop::DistanceSample& sample : samples) {
        for (const float distance : {sample.centre, sample.corner}) {
            // The corner behind the mirror counts as infinitely far.
            if (distance > 0.0f) nearest = std::min(nearest, distance);
            farthest =
                std::max(farthest, distance > 0.0f ? distance : std::numeric_limits<float>::infinity());
        }
    }
    const auto top = distances.bounds(0, 0, 4);
    ASSERT_EQ(top.size(), 1u);
    EXPECT_EQ(top.front().nearest, nearest);
    EXPECT_EQ(top.front().farthest, farthest);
    const auto finest = distances.bounds(0, 0, 0);
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            const interop::DistanceBounds& bounds = finest[y * 16 + x];
            for (std::uint32_t i = 0; i < 9; ++i) {
                const float centre = samples[(y + i / 3) * stride + x + i % 3].centre;
                if (centre > 0.0f) {
                    EXPECT_LE(bounds.nearest, centre);
                }
                EXPECT_GE(bounds.farthest, centre);
            }
        }
    }
}

}  // namespace
}  // namespace utsuri::test
