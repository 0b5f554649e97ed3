// SPDX-License-Identifier: Apache-2.0
// Of reflectors that lie behind each other, the nearest shows, and nothing is looked up for the others.
#include "support/methods.h"
#include "support/test_device.h"

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{32, 24, 3, 4};
constexpr std::uint32_t kCubeFaces = 6;

/// A plane mirror so wide that the eye sees nothing else, and a mirroring ball behind it.
Scene mirror_before_ball(bool ball_first) {
    const Mesh ball = icosphere({0, 0, -1}, 0.5f, 2);
    const Mesh wide = quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0});
    Scene scene;
    add(scene, ball_first ? ball : wide, mirror());
    add(scene, ball_first ? wide : ball, mirror());
    add(scene, room({-3, -3, -3}, {3, 3, 3}), emitter({0.3f, 0.5f, 0.2f}));
    return scene;
}

/// Two mirrors in one place, one of which shines red and the other green, brighter by far than the room.
Scene mirrors_in_one_place(bool red_first) {
    constexpr float kBright = 1000.0f;
    Material red = mirror();
    red.emissive = {kBright, 0, 0};
    Material green = mirror();
    green.emissive = {0, kBright, 0};
    Scene scene;
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), red_first ? red : green);
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), red_first ? green : red);
    add(scene, room({-3, -3, -3}, {3, 3, 3}), emitter({0.3f, 0.5f, 0.2f}));
    return scene;
}

Camera eye() {
    return look_at({0, 0, 1}, {0, 0, 0}, 0.6);
}

class HiddenReflectors : public DeviceTest {
  protected:
    static MapSettings settings() {
        MapSettings maps;
        maps.size = 16;
        maps.samples = 1;
        // With which hybrid looks all up.
        maps.tolerance = {Tolerance::Of::place, kMostPlaceTolerance};
        return maps;
    }
};

// The eye is on the axis of the wide mirror and sees nothing else: all that shows in it is the middle of the
// wall behind the eye, on the face +z of the cube. Of the ball's maps none is asked for.
TEST_F(HiddenReflectors, AskForNoMaps) {
    for (const bool ball_first : {false, true}) {
        DrawnScene scene(device(), mirror_before_ball(ball_first));
        for (const MapKind kind : {MapKind::cube, MapKind::proxy, MapKind::distance, MapKind::hybrid}) {
            const auto renderer = scene.renderer(kind, eye(), kPicture, settings());
            Progress silent;
            renderer->prepare(silent);
            EXPECT_EQ(renderer->statistics().maps, 2 * kCubeFaces);
            EXPECT_EQ(renderer->statistics().captured_maps, 1u) << DrawnMethod(kind);
        }
    }
}

// The later one lies on top.
TEST_F(HiddenReflectors, OfTwoInOnePlaceTheLaterShows) {
    for (const bool red_first : {false, true}) {
        const Scene scene = mirrors_in_one_place(red_first);
        DrawnScene drawn_scene(device(), scene);
        for (const glm::vec3& pixel : trace(device(), scene, eye(), kPicture, 1).image.pixels)
            EXPECT_EQ(pixel.x > pixel.y, !red_first);
        for (const MapKind kind : kMapKinds) {
            const Image drawn = drawn_scene.render(kind, eye(), kPicture, settings(), 1).image;
            for (const glm::vec3& pixel : drawn.pixels)
                EXPECT_EQ(pixel.x > pixel.y, !red_first) << DrawnMethod(kind);
        }
    }
}

}  // namespace
}  // namespace utsuri::test
