// SPDX-License-Identifier: Apache-2.0
// direct/cube-map and direct/proxy-map in rooms that shine with their own position.
#include "support/light_scenes.h"
#include "support/test_device.h"
#include "support/worked_room.h"

#include "map_observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSize = 128;
/// As in polygon_map_test.cpp: texels of 2 / N rad at the centre of a face, looked at to a quarter.
constexpr double kTexel = 0.25 * 2.0 / kSize;

class PixelMaps : public DeviceTest {};

// A room that is its own proxy has no parallax error at all: exact where the infinite map is wrong by up to
// 73 degrees.
TEST_F(PixelMaps, ProxyShowsTheTrueHitsInAnEmptyRoom) {
    MapObserver observer(device(), worked_room(), MapKind::proxy, map_settings(kSize, kWorkedCapturePoint));
    for (const WorkedPoint& point : kWorkedPoints) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point.mirror, 4).mean);
        EXPECT_LE(angle_between(seen - kWorkedCapturePoint, point.hit - kWorkedCapturePoint), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
}

TEST_F(PixelMaps, CubeShowsTheInfiniteMap) {
    MapObserver observer(device(), worked_room(), MapKind::cube, map_settings(kSize, kWorkedCapturePoint));
    for (const WorkedPoint& point : kWorkedPoints) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point.mirror, 4).mean);
        EXPECT_LE(angle_between(seen - kWorkedCapturePoint, point.infinite - kWorkedCapturePoint), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
}

// On a coarse ball vectors per pixel follow the interpolated normal exactly, where vectors per vertex are off
// by up to beta^2 / 4 of its 37 degrees between vertices and more.
TEST_F(PixelMaps, CubeNeedsNoFinePolygons) {
    const CodedRoom hall(glm::dvec3(-200.0), glm::dvec3(200.0));
    Scene scene;
    hall.add_to(scene);
    add(scene, icosphere(glm::vec3(0.0f), 1.0f, 1), mirror());
    Observer traced(device(), scene);
    RenderSettings picture;
    picture.width = picture.height = 48;
    const Camera camera = look_at({3, 2, 2.5}, {0, 0, 0}, 0.3);
    const Image reference = traced.picture(camera, picture, 16);
    const auto mean_error = [&](MapKind kind) {
        const Image image =
            MapObserver(device(), scene, kind, map_settings(kSize)).picture(camera, picture, 16);
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            sum += glm::length(glm::dvec3(image.pixels[i]) - glm::dvec3(reference.pixels[i]));
        return sum / static_cast<double>(image.pixels.size());
    };
    const double cube = mean_error(MapKind::cube);
    // Parallax of a radius in 200, a texel, half of each in codes of 0 to 1.
    EXPECT_LE(cube, 2.0 / 200.0 + 2.0 / kSize);
    EXPECT_GE(mean_error(MapKind::polygon), 3.0 * cube);
}

/// Shows what an eye sees in a mirror by proxy-map: the true hits, up to a texel.
void expect_true_hits(MapObserver& observer, const CodedWalls& walls, const glm::dvec3& eye,
                      const std::vector<glm::dvec3>& mirror_points, const glm::dvec3& normal,
                      const glm::dvec3& capture_point) {
    for (const glm::dvec3& point : mirror_points) {
        const glm::dvec3 seen = walls.decode(observer.look(eye, point, 4).mean);
        const glm::dvec3 hit = walls.wall_point(point, glm::reflect(point - eye, normal));
        EXPECT_LE(angle_between(seen - capture_point, hit - capture_point), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
}

TEST_F(PixelMaps, ProxyShowsTheTrueHitsInATurnedRoom) {
    const glm::dvec3 capture_point = turned(kWorkedCapturePoint, kWorkedTurn);
    MapObserver observer(device(), turned_worked_room(), MapKind::proxy, map_settings(kSize, capture_point));
    std::vector<glm::dvec3> mirror_points;
    for (const WorkedPoint& point : kWorkedPoints)
        mirror_points.push_back(turned(point.mirror, kWorkedTurn));
    expect_true_hits(observer, turned_worked_walls(), turned(kWorkedEye, kWorkedTurn), mirror_points,
                     turned({0, 0, 1}, kWorkedTurn), capture_point);
}

TEST_F(PixelMaps, ProxyShowsTheTrueHitsInAHexagonalRoom) {
    const HexagonalHall hall;
    MapObserver observer(device(), hall.scene(), MapKind::proxy, map_settings(kSize, hall.capture_point));
    expect_true_hits(observer, hall.walls, hall.eye, hall.mirror_points, {0, 0, 1}, hall.capture_point);
}

// Walls hide what is beyond them of a mirror, and no ray that is seen starts there.
TEST_F(PixelMaps, ProxyShowsTheTrueHitsInAMirrorThatReachesOutOfItsRoom) {
    Scene scene;
    kWorkedRoom.add_to(scene);
    add(scene, quad({-2, -2, 1}, {8, 0, 0}, {0, 7, 0}), mirror());
    MapObserver observer(device(), scene, MapKind::proxy, map_settings(kSize, kWorkedCapturePoint));
    for (const glm::dvec3& point : {glm::dvec3(2.5, 2, 1), glm::dvec3(1, 1, 1), glm::dvec3(3, 0.4, 1)}) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point, 4).mean);
        const glm::dvec3 hit =
            kWorkedRoom.wall_point(point, glm::reflect(point - kWorkedEye, glm::dvec3(0, 0, 1)));
        EXPECT_LE(angle_between(seen - kWorkedCapturePoint, hit - kWorkedCapturePoint), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
}

TEST_F(PixelMaps, AGivenProxyThatIsTheRoomIsTheFittedOne) {
    RenderSettings picture;
    picture.width = picture.height = 32;
    const auto largest_difference = [&](const Scene& scene, const Camera& camera, MapSettings settings,
                                        const std::vector<HalfSpace>& planes) {
        const Image fitted =
            MapObserver(device(), scene, MapKind::proxy, settings).picture(camera, picture, 4);
        settings.proxy = GivenProxy{"room.txt", planes};
        const Image given =
            MapObserver(device(), scene, MapKind::proxy, settings).picture(camera, picture, 4);
        float largest = 0.0f;
        for (std::size_t i = 0; i < given.pixels.size(); ++i)
            largest = std::max(largest, glm::length(given.pixels[i] - fitted.pixels[i]));
        return largest;
    };
    const std::vector<HalfSpace> box = turned_room({0, 0, 0}, {4, 3, 5}, 0.0).planes();
    EXPECT_EQ(largest_difference(worked_room(), look_at(kWorkedEye, {2, 1.5, 0}),
                                 map_settings(kSize, kWorkedCapturePoint), box),
              0.0f);
    const HexagonalHall hall;
    // Planes of walls whose corners are rounded turn by 1e-7 and some; so do places in maps of up to eight
    // levels, of which a texel shows as much as a wall has.
    EXPECT_LE(largest_difference(hall.scene(), look_at(hall.eye, {1, 1.3, -1.3}),
                                 map_settings(kSize, hall.capture_point), hall.walls.planes()),
              8.0f * kSize * 1e-6f);
}

// Fitted planes on the device, too, know no absolute length.
TEST_F(PixelMaps, PlanesShowTheSameBitsAtAnyScale) {
    const HexagonalHall hall;
    RenderSettings picture;
    picture.width = picture.height = 16;
    const auto shown = [&](double factor) {
        MapObserver observer(device(), scaled(hall.scene(), factor), MapKind::proxy,
                             map_settings(16, factor * hall.capture_point));
        return observer.picture(look_at(factor * hall.eye, factor * glm::dvec3(1, 1.3, -1.3)), picture, 2);
    };
    const Image original = shown(1.0);
    for (const int k : {-20, 20})
        EXPECT_TRUE(shown(std::ldexp(1.0, k)).pixels == original.pixels) << "k = " << k;
}

// A given proxy need not hold the mirror. Rays that start outside and come in leave on the far side; those
// that do not are looked up where they start.
TEST_F(PixelMaps, RaysFromOutsideAProxyLeaveItOnTheFarSide) {
    Scene scene;
    kWorkedRoom.add_to(scene);
    add(scene, quad({0.1f, 0.1f, 1}, {3.8f, 0, 0}, {0, 2.8f, 0}), mirror());
    // [1, 3] x [0, 3] x [0, 4], and the same cut off where x + y = 5.5, which takes planes.
    std::vector<HalfSpace> box = turned_room({1, 0, 0}, {3, 3, 4}, 0.0).planes();
    std::vector<HalfSpace> cut = box;
    cut.push_back({glm::normalize(glm::dvec3(1, 1, 0)), 5.5 / std::sqrt(2.0)});
    for (const std::vector<HalfSpace>& planes : {box, cut}) {
        MapSettings settings = map_settings(kSize, kWorkedCapturePoint);
        settings.proxy = GivenProxy{"proxy.txt", planes};
        MapObserver observer(device(), scene, MapKind::proxy, settings);
        const auto expect_looked_up = [&](const glm::dvec3& eye, const glm::dvec3& mirror,
                                          const glm::dvec3& place) {
            const glm::dvec3 seen = kWorkedRoom.decode(observer.look(eye, mirror, 4).mean);
            const glm::dvec3 expected =
                kWorkedRoom.wall_point(kWorkedCapturePoint, place - kWorkedCapturePoint);
            EXPECT_LE(angle_between(seen - kWorkedCapturePoint, expected - kWorkedCapturePoint), kTexel)
                << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
        };
        // Mirrored along (0.4, 0.1, 1): into the box at x = 1, out of it at z = 4.
        expect_looked_up({0.1, 0.9, 2}, {0.5, 1, 1}, {1.7, 1.3, 4});
        // Mirrored along (-0.4, 0, 1): past it.
        expect_looked_up({0.9, 1.5, 2}, {0.5, 1.5, 1}, {0.5, 1.5, 1});
    }
}

}  // namespace
}  // namespace utsuri::test
