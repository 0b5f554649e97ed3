// SPDX-License-Identifier: Apache-2.0
// Perfect mirrors: what they show is known from plane geometry.
#include "support/coded_room.h"
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

constexpr unsigned kLowerZ = 1u << 4;

class Mirrors : public DeviceTest {};

/// A look from `eye`, all pixels of which show the same point, told as the point of the room that is seen.
glm::dvec3 seen_point(Observer& observer, const CodedRoom& coded, glm::dvec3 eye, glm::dvec3 target) {
    return coded.decode(observer.look(eye, target, 16).mean);
}

// The view in a plane mirror is the direct view of the mirrored eye, pixel by pixel: its picture is mirrored
// too, which a left-handed camera makes the same pixels with the same samples.
TEST_F(Mirrors, PlaneMirrorShowsTheViewOfTheMirroredEye) {
    // Hit points have errors of some units in the last place of the room's size, 2^-23 * 8 m.
    constexpr float kCodingError = 1e-5f;
    const CodedRoom coded({-4, -3, -3}, {4, 3, 5});
    Scene open;
    coded.add_to(open, kLowerZ);
    Scene mirrored = open;
    add(mirrored, quad({-4, -3, 0}, {8, 0, 0}, {0, 6, 0}), mirror());
    Camera camera;
    camera.position = {0.3, 0.2, 2.0};
    camera.vertical_fov = 1.2;
    RenderSettings settings;
    settings.width = settings.height = 48;
    const Image in_mirror = Observer(device(), mirrored).picture(camera, settings, 4);
    camera.position.z = -camera.position.z;
    camera.forward.z = -camera.forward.z;
    const Image direct = Observer(device(), open).picture(camera, settings, 4);
    for (std::size_t i = 0; i < direct.pixels.size(); ++i) {
        ASSERT_LE(glm::length(in_mirror.pixels[i] - direct.pixels[i]), kCodingError) << "pixel " << i;
    }
    EXPECT_GT(glm::length(direct.at(0, 0) - direct.at(47, 47)), 0.1f);
}

// A shining letter L behind the eye, its foot towards +x. In a mirror seen along -z, +x stays on the right
// and below stays below; nothing is turned round, as it would be for somebody who turns to look.
TEST_F(Mirrors, ALetterInAMirrorIsTheRightWayRound) {
    Scene scene;
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), mirror());
    const glm::vec3 shine(1.0f);
    add(scene, flipped(quad({-0.5f, -1, 4}, {0.4f, 0, 0}, {0, 2, 0})), emitter(shine));
    add(scene, flipped(quad({-0.5f, -1, 4}, {1.2f, 0, 0}, {0, 0.4f, 0})), emitter(shine));
    Observer observer(device(), scene);
    const glm::dvec3 eye(0.0, 0.0, 2.0);
    const auto brightness = [&](double x, double y) {
        // The mirrored letter lies at z = -4.
        return observer.look(eye, {x, y, -4.0}, 2).mean.x;
    };
    EXPECT_DOUBLE_EQ(brightness(-0.3, 0.8), 1.0);
    EXPECT_DOUBLE_EQ(brightness(-0.3, -0.8), 1.0);
    EXPECT_DOUBLE_EQ(brightness(0.5, -0.8), 1.0);
    EXPECT_DOUBLE_EQ(brightness(0.5, 0.8), 0.0);
    EXPECT_DOUBLE_EQ(brightness(-0.8, -0.8), 0.0);
    EXPECT_DOUBLE_EQ(brightness(0.3, 0.0), 0.0);
}

// At a vertex of the ball the position and the smooth normal are those of the sphere, n = p / R: the ray
// along d leaves along d - 2 (d . n) n.
TEST_F(Mirrors, ABallReflectsByItsNormal) {
    const CodedRoom coded(glm::dvec3(-50.0), glm::dvec3(50.0));
    Scene scene;
    coded.add_to(scene);
    const Mesh ball = icosphere(glm::vec3(0.0f), 1.0f, 2);
    add(scene, ball, mirror());
    Observer observer(device(), scene);
    const glm::dvec3 eye(1.0, 2.0, 3.0);
    int vertices = 0;
    for (std::size_t i = 0; i < ball.positions.size(); i += 7) {
        const glm::dvec3 point(ball.positions[i]);
        const glm::dvec3 along = glm::normalize(point - eye);
        const double cosine = -glm::dot(along, glm::normalize(point));
        if (cosine < 0.3) continue;
        ++vertices;
        // Within a close-up, the normal turns by its width over the radius, and the reflection by twice that.
        const double spread = 2.0 * kCloseUpAngle * glm::length(point - eye) / cosine;
        const glm::dvec3 wall = seen_point(observer, coded, eye, point);
        EXPECT_LE(angle_between(wall - point, glm::reflect(along, glm::normalize(point))), spread)
            << "vertex " << i;
    }
    EXPECT_GE(vertices, 5);
}

/// Two mirrors of reflectance 0.9 that face each other at a distance of 1, for x <= 1.
Scene facing_mirrors(float emission) {
    Material material = mirror();
    material.base_colour = glm::vec3(0.9f);
    material.emissive = glm::vec3(emission);
    Scene scene;
    add(scene, quad({-1, -1, -0.5f}, {2, 0, 0}, {0, 2, 0}), material);
    add(scene, flipped(quad({-1, -1, 0.5f}, {2, 0, 0}, {0, 2, 0})), material);
    return scene;
}

constexpr double kReflectance = static_cast<double>(0.9f);

Image look_along(Observer& observer, const glm::dvec3& direction, std::uint32_t depth,
                 std::uint32_t samples = 2) {
    RenderSettings settings;
    settings.width = settings.height = kCloseUpSize;
    settings.max_depth = depth;
    return observer.picture(look_at({0, 0, 0}, direction, kCloseUpAngle), settings, samples);
}

// Unfolded, the path advances tan = 0.1 a crossing and half of that before the first hit: hits at x = (k -
// 1/2) / 10, the tenth at 0.95; then it leaves for the environment of radiance 1. Each hit reflects by
// Schlick's curve at that angle.
TEST_F(Mirrors, AChainOfTenReflections) {
    Scene scene = facing_mirrors(0.0f);
    scene.environment = glm::vec3(1.0f);
    Observer observer(device(), scene);
    const double cosine = 1.0 / std::sqrt(1.01);
    const double reflectance = kReflectance + (1.0 - kReflectance) * std::pow(1.0 - cosine, 5.0);
    constexpr std::uint64_t kSamples = 2 * kCloseUpSize * kCloseUpSize;

    expect_radiance(estimate_of(look_along(observer, {0.1, 0, 1}, 10)), std::pow(reflectance, 10.0), 1e-6);
    EXPECT_EQ(observer.counts().truncated, 0u);
    EXPECT_EQ(observer.counts().lookups, 10 * kSamples);
    EXPECT_EQ(observer.counts().traced, 10 * kSamples);

    // One reflection short, the path ends on a mirror.
    expect_radiance(estimate_of(look_along(observer, {0.1, 0, 1}, 9)), 0.0);
    EXPECT_EQ(observer.counts().truncated, kSamples);
    EXPECT_EQ(observer.counts().traced, 9 * kSamples);
}

// Mirrors that shine with radiance 1 add up to 1 + rho + ... + rho^depth along the common axis.
TEST_F(Mirrors, SpecularDepthCutsTheSeries) {
    Observer observer(device(), facing_mirrors(1.0f));
    double sum = 0.0;
    for (std::uint32_t depth = 0; depth <= 3; ++depth) {
        sum += std::pow(kReflectance, depth);
        SCOPED_TRACE(depth);
        expect_radiance(estimate_of(look_along(observer, {0, 0, 1}, depth)), sum, 1e-6);
        EXPECT_EQ(observer.counts().truncated, 2u * kCloseUpSize * kCloseUpSize);
    }
}

TEST_F(Mirrors, AHundredReflectionsKeepTheirAccuracy) {
    Observer observer(device(), facing_mirrors(1.0f));
    const double sum = (1.0 - std::pow(kReflectance, 101.0)) / (1.0 - kReflectance);
    // A throughput of k factors carries k roundings, each of at most 2^-24.
    const Estimate estimate = estimate_of(look_along(observer, {0, 0, 1}, 100));
    EXPECT_NEAR(estimate.mean.x, sum, 100.0 * 0x1p-24 * sum);
}

// A mirror seen in a mirror shows the scene unmirrored: two at right angles send light back where it came
// from.
TEST_F(Mirrors, ACornerOfTwoMirrorsReturnsLight) {
    const CodedRoom coded(glm::dvec3(-10.0), glm::dvec3(10.0));
    Scene scene;
    coded.add_to(scene);
    add(scene, quad({0, -1, 0}, {0, 2, 0}, {0, 0, 4}), mirror());
    add(scene, quad({0, -1, 0}, {4, 0, 0}, {0, 2, 0}), mirror());
    Observer observer(device(), scene);
    const glm::dvec3 eye(2.0, 0.0, 1.5);
    for (const glm::dvec3 target : {glm::dvec3(0, 0.1, 0.7), glm::dvec3(0.9, -0.2, 0)}) {
        const glm::dvec3 along = target - eye;
        // Both horizontal components turn round; the vertical one stays. The mirrored eye is at (-x, y, -z).
        const glm::dvec3 image(-eye.x, eye.y, -eye.z);
        const glm::dvec3 expected = coded.wall_point(image, {-along.x, along.y, -along.z});
        const double spread = 2.0 * kCloseUpAngle * 20.0;
        EXPECT_LE(glm::length(seen_point(observer, coded, eye, target) - expected), spread);
    }
}

}  // namespace
}  // namespace utsuri::test
