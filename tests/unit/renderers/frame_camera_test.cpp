// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/frame_camera.h"

#include "renderers/film/film_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace utsuri {
namespace {

TEST(FrameCamera, ScalesItsAxesToTheEdgesOfThePicture) {
    Camera camera;
    camera.position = {10.0, 20.0, 30.0};
    camera.vertical_fov = std::numbers::pi / 2.0;
    const interop::CameraInfo info = make_camera_info(camera, {9.0, 20.0, 32.0}, 400, 200);
    EXPECT_EQ(info.origin, glm::vec3(1.0f, 0.0f, -2.0f));
    EXPECT_EQ(info.forward, glm::vec3(0.0f, 0.0f, -1.0f));
    // tan(45 degrees) upwards, twice that to the side of a picture twice as wide as high.
    EXPECT_FLOAT_EQ(info.up.y, 1.0f);
    EXPECT_FLOAT_EQ(info.right.x, 2.0f);
    EXPECT_EQ(info.right.y, 0.0f);
}

TEST(FrameCamera, SubtractsTheOriginInFloat64) {
    Camera camera;
    camera.position = {1e9 + 0.125, 0.0, 0.0};
    EXPECT_EQ(make_camera_info(camera, {1e9, 0.0, 0.0}, 1, 1).origin.x, 0.125f);
}

TEST(FrameCamera, CountsTilesThatArePartlyFilled) {
    EXPECT_EQ(tile_count(8, 8), 1u);
    EXPECT_EQ(tile_count(9, 8), 2u);
    EXPECT_EQ(tile_count(1, 1), 1u);
    EXPECT_EQ(tile_count(17, 25), 3u * 4u);
}

}  // namespace
}  // namespace utsuri
