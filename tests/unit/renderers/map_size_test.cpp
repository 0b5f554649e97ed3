// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/map_size.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

/// The reflector is instance 0 of every scene here.
constexpr glm::dvec3 kCentre{0.0};
constexpr std::uint32_t kMost = 4096;
/// Of the cube: two units at a distance of one.
constexpr double kTexelAngle = 2.0;
/// Sizes are rounded up to a multiple of this.
constexpr std::uint32_t kStep = 8;

MapView view_from(const glm::dvec3& eye, double angle, std::uint32_t width, std::uint32_t height) {
    return {test::look_at(eye, kCentre, angle), width, height};
}

std::uint32_t fitted(const Scene& scene, MapKind kind, const MapView& view, const glm::dvec3& probe = kCentre,
                     std::uint32_t most = kMost) {
    const SceneData data = prepare_scene_data(scene);
    const Reflectors reflectors = find_reflectors(data);
    return fit_map_sizes(data, reflectors, {{0, probe - data.origin}}, kind, view, kTexelAngle, most).at(0);
}

std::uint32_t rounded_up(double size) {
    return static_cast<std::uint32_t>(std::ceil(size / kStep)) * kStep;
}

Scene plane_mirror() {
    Scene scene;
    test::add(scene, test::quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), test::mirror());
    return scene;
}

// Far surroundings are seen in a plane mirror as finely as directly. The middle of the picture, where pixels
// are widest, is 2 tan(angle / 2) / height radians a pixel, the corner's pixels less by cos^3 in solid angle:
// for 0.2 radians and a square picture by 3 %.
TEST(MapSize, PlaneMirrorNeedsTexelsAsWideAsPixels) {
    constexpr double kAngle = 0.2;
    for (const std::uint32_t height : {64u, 128u, 320u}) {
        const double pixel = 2.0 * std::tan(0.5 * kAngle) / height;
        const std::uint32_t size =
            fitted(plane_mirror(), MapKind::cube, view_from({0, 0, 3}, kAngle, height, height));
        EXPECT_GE(size, rounded_up(kTexelAngle / pixel));
        EXPECT_LE(size, rounded_up(1.03 * kTexelAngle / pixel)) << height;
    }
}

// A ball of radius r at a distance d from the eye turns its normal by d / r of a pixel's angle from one pixel
// to the next, the mirrored ray by twice that more: 1 + 2 d / r in its middle.
TEST(MapSize, BallNeedsFewer) {
    constexpr double kRadius = 0.5;
    constexpr double kDistance = 10.0;
    constexpr double kAngle = 0.01;  // the middle of the ball alone
    constexpr std::uint32_t kHeight = 64;
    Scene scene;
    test::add(scene, test::icosphere({0, 0, 0}, kRadius, 5), test::mirror());
    const double pixel = 2.0 * std::tan(0.5 * kAngle) / kHeight;
    const double spread = 1.0 + 2.0 * kDistance / kRadius;
    const double needed = kTexelAngle / (pixel * spread);
    const auto size = static_cast<double>(
        fitted(scene, MapKind::cube, view_from({0, 0, kDistance + kRadius}, kAngle, kHeight, kHeight)));
    // Normals are interpolated over triangles 1/16 of the radius wide: their turn is even but for a few
    // percent.
    EXPECT_NEAR(size / needed, 1.0, 0.1) << size;
}

// What is close to a mirror is seen larger from the mirror than from the eye: a wall at a distance w from the
// probe, seen by way of the mirror at e + w from the eye, needs (e + w) / w times fewer texels than what is
// far. In a direction at right angles to wall and mirror, up to the picture's corner 2 % off.
TEST(MapSize, NearSurroundingsNeedFewerWhereLookUpsAreCorrected) {
    constexpr double kEye = 3.0;
    constexpr double kWall = 4.0;
    constexpr double kAngle = 0.1;
    constexpr std::uint32_t kHeight = 64;
    Scene scene = plane_mirror();
    test::add(scene, test::quad({-9, -9, kWall}, {18, 0, 0}, {0, 18, 0}), test::lambert(glm::vec3(0.5f)));
    const double pixel = 2.0 * std::tan(0.5 * kAngle) / kHeight;
    const MapView view = view_from({0, 0, kEye}, kAngle, kHeight, kHeight);
    const double far = kTexelAngle / pixel;
    for (const MapKind kind : {MapKind::proxy, MapKind::distance, MapKind::hybrid}) {
        const double needed = far * kWall / (kEye + kWall);
        EXPECT_NEAR(fitted(scene, kind, view), needed, 0.02 * needed + kStep);
    }
    for (const MapKind kind : {MapKind::polygon, MapKind::cube})
        EXPECT_NEAR(fitted(scene, kind, view), far, 0.02 * far + kStep);
}

TEST(MapSize, WhatIsNotSeenGetsLittleAndNothingMoreThanAllowed) {
    const MapView away{test::look_at({0, 0, 3}, {0, 0, 6}), 64, 48};
    EXPECT_EQ(fitted(plane_mirror(), MapKind::cube, away), kStep);
    EXPECT_EQ(fitted(plane_mirror(), MapKind::cube, away, kCentre, 5), 5u);
    const MapView close = view_from({0, 0, 3}, 0.001, 512, 384);
    EXPECT_EQ(fitted(plane_mirror(), MapKind::cube, close, kCentre, 100), 100u);
}

// An upright strip three pixels wide, where every fourth pixel of a row is looked at.
TEST(MapSize, NarrowReflectorsAreFound) {
    Scene scene;
    constexpr double kHeightSeen = 0.4;  // of the picture plane at the mirror, 2 metres before the eye
    const auto pixel = static_cast<float>(kHeightSeen / 384.0);
    test::add(scene, test::quad({-1.5f * pixel, -0.1f, 0}, {3.0f * pixel, 0, 0}, {0, 0.2f, 0}),
              test::mirror());
    const MapView view = view_from({0, 0, 2}, 2.0 * std::atan(0.1), 512, 384);
    EXPECT_GT(fitted(scene, MapKind::cube, view), kStep);
}

}  // namespace
}  // namespace utsuri
