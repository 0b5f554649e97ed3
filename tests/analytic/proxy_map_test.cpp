// SPDX-License-Identifier: Apache-2.0
// direct/cube-map and direct/proxy-map in rooms that shine with their own position.
#include "renderers/reflection_map/proxy_box.h"
#include "support/light_scenes.h"
#include "support/test_device.h"
#include "support/worked_room.h"

#include "map_observer.h"

#include <glm/geometric.hpp>

#include <cmath>

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

// The fitted box is the room, whatever stands in it; rays to its corners and furniture do not sway it.
TEST(ProxyBox, FindsTheWallsOfAFurnishedRoom) {
    Scene scene;
    add(scene, room({-2, 0, -3}, {4, 2.5f, 3}), lambert(glm::vec3(0.5f)));
    add(scene, room({2, 0, -1}, {3.5f, 0.9f, 1.2f}), lambert(glm::vec3(0.5f)));
    add(scene, icosphere({0.4f, 1.1f, 0.2f}, 0.3f, 2), mirror());
    const SceneData data = prepare_scene_data(scene);
    const glm::dvec3 point = glm::dvec3(0.4, 1.1, 0.2) - data.origin;
    const Bounds box = fit_proxy_box(data, 2, point);
    const glm::dvec3 lower = glm::dvec3(box.lower) + data.origin;
    const glm::dvec3 upper = glm::dvec3(box.upper) + data.origin;
    EXPECT_LE(glm::distance(lower, glm::dvec3(-2, 0, -3)), 1e-5);
    EXPECT_LE(glm::distance(upper, glm::dvec3(4, 2.5, 3)), 1e-5);
}

TEST(ProxyBox, HoldsItsReflectorAndItsPoint) {
    // A mirror that reaches through the only wall there is.
    Scene scene;
    add(scene, quad({-5, -5, -1}, {10, 0, 0}, {0, 10, 0}), lambert(glm::vec3(0.5f)));
    add(scene, icosphere({0, 0, 0}, 2.0f, 1), mirror());
    const SceneData data = prepare_scene_data(scene);
    const Bounds box = fit_proxy_box(data, 1, -data.origin);
    EXPECT_LE(static_cast<double>(box.lower.z) + data.origin.z, -1.9);
    EXPECT_GE(static_cast<double>(box.upper.x) + data.origin.x, 1.9);
}

TEST(ProxyBox, IsTheSceneWhereNothingSurrounds) {
    Scene scene;
    add(scene, icosphere({0, 0, 0}, 2.0f, 1), mirror());
    const SceneData data = prepare_scene_data(scene);
    const Bounds box = fit_proxy_box(data, 0, {0, 0, 0});
    EXPECT_EQ(box.lower, data.bounds.lower);
    EXPECT_EQ(box.upper, data.bounds.upper);
}

}  // namespace
}  // namespace utsuri::test
