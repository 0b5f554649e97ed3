// SPDX-License-Identifier: Apache-2.0
// Capture points, mirrors and eyes at places where they hardly ever are, in rooms that shine with their own
// position: what is seen is known in closed form there, too.
#include "support/light_scenes.h"
#include "support/test_device.h"
#include "support/worked_room.h"

#include "map_observer.h"

#include <glm/geometric.hpp>

#include <array>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSize = 64;
/// As in polygon_map_test.cpp: texels of 2 / N rad at the centre of a face, looked at to a quarter.
constexpr double kTexel = 0.25 * 2.0 / kSize;
constexpr unsigned kLowerX = 1u << 0;
constexpr unsigned kLowerZ = 1u << 4;

/// Points of the mirror wall z = 0, seen from kWorkedEye.
const std::array<glm::dvec3, 3> kMirrorPoints = {{{2.5, 2, 0}, {1, 1, 0}, {0.4, 1.2, 0}}};

/// Where an eye looks after the wall z = 0 has mirrored its ray.
glm::dvec3 mirrored(const glm::dvec3& eye, const glm::dvec3& point) {
    return glm::reflect(point - eye, glm::dvec3(0, 0, 1));
}

/// Methods that show a map as if what it shows were infinitely far.
class InfiniteMap : public DeviceTest, public testing::WithParamInterface<MapKind> {
  protected:
    /// On the wall z = 0 the eye must see what a ray along the mirrored one meets from the capture point.
    static void expect_seen_from(const glm::dvec3& capture_point, MapObserver& observer,
                                 const glm::dvec3& eye, const glm::dvec3& point) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(eye, point, 4).mean);
        const glm::dvec3 expected = kWorkedRoom.wall_point(capture_point, mirrored(eye, point));
        EXPECT_LE(angle_between(seen - capture_point, expected - capture_point), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
};

TEST_P(InfiniteMap, CapturedAtTheEye) {
    MapObserver observer(device(), worked_room(), GetParam(), map_settings(kSize, kWorkedEye));
    for (const glm::dvec3& point : kMirrorPoints)
        expect_seen_from(kWorkedEye, observer, kWorkedEye, point);
}

// Rays start in the plane of the wall x = 4: those that go inwards see the room and not that wall, those that
// go outwards see nothing.
TEST_P(InfiniteMap, CapturedOnASurface) {
    const glm::dvec3 on_wall(4, 1.5, 2.5);
    MapObserver observer(device(), worked_room(), GetParam(), map_settings(kSize, on_wall));
    const glm::dvec3 inwards(0.4, 1.2, 0);
    expect_seen_from(on_wall, observer, kWorkedEye, inwards);
    const glm::dvec3 outwards(2.5, 2, 0);
    EXPECT_EQ(observer.look(kWorkedEye, outwards, 4).mean, glm::dvec3(0.0));
}

// Emission leaves the front of a surface, unless it is double-sided: from inside a block is black or shines.
TEST_P(InfiniteMap, CapturedInsideABlock) {
    for (const bool double_sided : {false, true}) {
        Scene scene = worked_room();
        add(scene, block({1.7f, 1.2f, 2.2f}, {2.3f, 1.8f, 2.8f}), emitter(glm::vec3(5.0f)));
        scene.materials.back().double_sided = double_sided;
        MapObserver observer(device(), scene, GetParam(), map_settings(kSize, kWorkedCapturePoint));
        EXPECT_EQ(observer.look(kWorkedEye, kMirrorPoints[0], 4).mean, glm::dvec3(double_sided ? 5.0 : 0.0));
    }
}

// The mirror stands on the floor, in the corner, a quarter of a millimetre in front of its wall; its own
// capture point lies in it.
TEST_P(InfiniteMap, MirrorThatTouchesTheWalls) {
    constexpr float kGap = 0x1p-12f;
    Scene scene;
    kWorkedRoom.add_to(scene);
    add(scene, quad({0, 0, kGap}, {3, 0, 0}, {0, 2.5f, 0}), mirror());
    MapObserver observer(device(), scene, GetParam(), map_settings(kSize));
    const glm::dvec3 centre(1.5, 1.25, static_cast<double>(kGap));
    for (const glm::dvec3& point : kMirrorPoints)
        expect_seen_from(centre, observer, kWorkedEye, point);
}

// A mirror 25 times as large as the room, in place of its wall.
TEST_P(InfiniteMap, MirrorLargerThanTheRoom) {
    Scene scene;
    kWorkedRoom.add_to(scene, kLowerZ);
    add(scene, quad({-48, -48.5f, 0}, {100, 0, 0}, {0, 100, 0}), mirror());
    MapObserver observer(device(), scene, GetParam(), map_settings(kSize, kWorkedCapturePoint));
    for (const glm::dvec3& point : kMirrorPoints)
        expect_seen_from(kWorkedCapturePoint, observer, kWorkedEye, point);
}

// Seen at a tenth of a degree the close and the far corners of a polygon differ in distance by a factor of
// 20, and its vectors by as much in length.
TEST_P(InfiniteMap, GlancingMirror) {
    MapObserver observer(device(), worked_room(), GetParam(), map_settings(kSize, kWorkedCapturePoint));
    const glm::dvec3 eye(0.2, 1.5, 0.005);
    expect_seen_from(kWorkedCapturePoint, observer, eye, {3, 1.2, 0});
    expect_seen_from(kWorkedCapturePoint, observer, eye, {1.5, 2.5, 0});
}

// Two mirrors share an edge. The map of the first holds what the second mirrors: from the middle, a ray that
// meets the second at (0, 1.02, 4.1) and then the far wall.
TEST_P(InfiniteMap, MirrorsThatTouch) {
    Scene scene;
    kWorkedRoom.add_to(scene, kLowerX | kLowerZ);
    add(scene, quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), mirror());
    add(scene, quad({0, 0, 0}, {0, 3, 0}, {0, 0, 5}), mirror());
    MapObserver observer(device(), scene, GetParam(), map_settings(kSize, kWorkedCapturePoint));
    const glm::dvec3 eye(3.5, 1.6, 2);
    const glm::dvec3 seen = kWorkedRoom.decode(observer.look(eye, {1, 1, 0}, 4).mean);
    const glm::dvec3 expected(1.125, 0.75, 5);
    // The mirror at x = 0 shows the capture point's image at x = -2.
    const glm::dvec3 image(-kWorkedCapturePoint.x, kWorkedCapturePoint.y, kWorkedCapturePoint.z);
    EXPECT_LE(angle_between(seen - image, expected - image), kTexel)
        << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
}

INSTANTIATE_TEST_SUITE_P(Kinds, InfiniteMap, testing::Values(MapKind::polygon, MapKind::cube),
                         [](const auto& kind) {
                             return kind.param == MapKind::polygon ? "polygon" : "cube";
                         });

using ProxyExtremes = DeviceTest;

// The room is its own proxy: what a mirror shows is true wherever its map was captured.
TEST_F(ProxyExtremes, CapturedAtTheEyeAndInTheMirror) {
    for (const glm::dvec3& capture_point : {kWorkedEye, glm::dvec3(2, 1.5, 0x1p-12)}) {
        MapObserver observer(device(), worked_room(), MapKind::proxy, map_settings(kSize, capture_point));
        for (const glm::dvec3& point : kMirrorPoints) {
            const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point, 4).mean);
            const glm::dvec3 hit = kWorkedRoom.wall_point(point, mirrored(kWorkedEye, point));
            EXPECT_LE(angle_between(seen - capture_point, hit - capture_point), kTexel)
                << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
        }
    }
}

// At a tenth of a degree the mirrored ray meets a wall millimetres from the mirror's plane; so the room goes
// on behind it, for texels to have neighbours there.
TEST_F(ProxyExtremes, GlancingMirror) {
    const CodedRoom deep_room({0, 0, -1}, {4, 3, 5});
    Scene scene;
    deep_room.add_to(scene);
    add(scene, quad({0.1f, 0.1f, 0}, {3.8f, 0, 0}, {0, 2.8f, 0}), mirror());
    MapObserver observer(device(), scene, MapKind::proxy, map_settings(kSize, kWorkedCapturePoint));
    const glm::dvec3 eye(0.2, 1.5, 0.005);
    for (const glm::dvec3& point : {glm::dvec3(3, 1.2, 0), glm::dvec3(1.5, 2.5, 0)}) {
        const glm::dvec3 seen = deep_room.decode(observer.look(eye, point, 4).mean);
        const glm::dvec3 hit = deep_room.wall_point(point, mirrored(eye, point));
        EXPECT_LE(angle_between(seen - kWorkedCapturePoint, hit - kWorkedCapturePoint), kTexel)
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
}

}  // namespace
}  // namespace utsuri::test
