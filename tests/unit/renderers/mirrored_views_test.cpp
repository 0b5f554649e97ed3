// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/mirrored_views.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri {
namespace {

constexpr std::uint32_t kSize = 100;
constexpr double kNear = 1e-6;

PlaneMirror rectangle(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    PlaneMirror mirror;
    mirror.normal = glm::normalize(glm::cross(u, v));
    mirror.offset = glm::dot(mirror.normal, corner);
    mirror.tolerance = 1e-6;
    mirror.outline = {corner, corner + u, corner + u + v, corner + v};
    return mirror;
}

std::vector<MirroredView> images_of(const std::vector<PlaneMirror>& mirrors, const Camera& eye,
                                    std::uint32_t reflections, std::uint32_t most = kMostMirroredViews) {
    return plan_mirrored_views(mirrors, eye, kSize, kSize, kNear, reflections, 0, most);
}

/// A mirror of 2 m by 2 m in z = 0.
PlaneMirror upright() {
    return rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
}

// The image of q in the plane n . x = d is q - 2 (n . q - d) n.
TEST(MirroredViews, AreSeenFromTheMirroredEye) {
    const PlaneMirror tilted = rectangle({-1, -1, 0.2}, {2, 0, 0.5}, {0, 2, -0.3});
    const Camera eye = test::look_at({0.3, 0.4, 3}, {0, 0, 0}, 1.0);
    const std::vector<MirroredView> images = images_of({tilted}, eye, 1);
    ASSERT_EQ(images.size(), 2u);
    const glm::dvec3& n = tilted.normal;
    const auto mirrored = [&](const glm::dvec3& q) { return q - 2.0 * (glm::dot(n, q) - tilted.offset) * n; };
    const Camera& image = images[1].eye;
    EXPECT_LE(glm::distance(image.position, mirrored(eye.position)), 1e-14);
    EXPECT_LE(glm::distance(image.position + image.right, mirrored(eye.position + eye.right)), 1e-14);
    EXPECT_LE(glm::distance(image.position + image.up, mirrored(eye.position + eye.up)), 1e-14);
    EXPECT_LE(glm::distance(image.position + image.forward, mirrored(eye.position + eye.forward)), 1e-14);
    // What shows is on the eye's side.
    EXPECT_GT(glm::dot(images[1].normal, eye.position), images[1].offset);
    EXPECT_LT(glm::dot(images[1].normal, image.position), images[1].offset);
}

TEST(MirroredViews, HaveTheWindowOfTheirMirror) {
    Camera eye;
    eye.position = {0, 0, 4};
    eye.vertical_fov = 2.0 * std::atan(0.51);
    // 2 m at 4 m, where the picture is 4.08 m wide: pixels 25.5 to 74.5, and one more on each side.
    const std::vector<MirroredView> images = images_of({upright()}, eye, 1);
    ASSERT_EQ(images.size(), 2u);
    EXPECT_EQ(images[1].window, (PixelRect{24, 24, 52, 52}));
    eye.position = {2, 0, 4};
    EXPECT_EQ(images_of({upright()}, eye, 1)[1].window, (PixelRect{0, 24, 27, 52}));
    // Both sides reflect.
    eye.position = {0, 0, -4};
    eye.forward = {0, 0, 1};
    EXPECT_EQ(images_of({upright()}, eye, 1)[1].window, (PixelRect{24, 24, 52, 52}));
}

TEST(MirroredViews, OfWhatCannotBeSeenAreLeftOut) {
    Camera eye;
    eye.position = {0, 0, 4};
    EXPECT_EQ(images_of({upright()}, eye, 0).size(), 1u);
    const auto seen = [&](glm::dvec3 position, glm::dvec3 target) {
        return images_of({upright()}, test::look_at(position, target, 0.8), 1).size() == 2;
    };
    EXPECT_TRUE(seen({0, 0, 4}, {0, 0, 0}));
    EXPECT_FALSE(seen({0, 0, 4}, {0, 0, 9})) << "behind the eye";
    EXPECT_FALSE(seen({0, 0, 4}, {8, 0, 0})) << "beside the picture";
    EXPECT_FALSE(seen({5, 0, 0}, {0, 0, 0})) << "edge on";
    EXPECT_FALSE(seen({0, 0, 0}, {0, 0, 1})) << "the eye on the mirror";
    EXPECT_TRUE(seen({0, 0.5, 1e-3}, {0, 0.2, 0})) << "close to it";
}

// Of a mirror behind the plane of another nothing is seen in that, whichever way it faces.
TEST(MirroredViews, ShowOnlyWhatIsInFrontOfTheirMirror) {
    Camera eye;
    eye.position = {0, 0, 4};
    const PlaneMirror behind = rectangle({-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    // It can be seen past the edge of the first, whose back it then shows, and so on.
    const std::vector<MirroredView> past = images_of({upright(), behind}, eye, 5);
    EXPECT_EQ(past.size(), 7u);
    EXPECT_TRUE(past[1].shown.empty());
    const PlaneMirror in_front = rectangle({-1, -1, 6}, {2, 0, 0}, {0, 2, 0});
    // One image of each number of reflections, back and forth.
    const std::vector<MirroredView> images = images_of({upright(), in_front}, eye, 5);
    ASSERT_EQ(images.size(), 6u);
    for (std::uint32_t i = 1; i < 6; ++i) {
        EXPECT_EQ(images[i].reflections, i);
        EXPECT_EQ(images[i].mirror, (i + 1) % 2);
        ASSERT_EQ(images[i - 1].shown.size(), 1u);
        EXPECT_EQ(images[i - 1].shown.front().view, i);
        // Unfolded, the mirrors stand 6 m apart.
        EXPECT_NEAR(glm::length(images[i].eye.position - glm::dvec3(0, 0, (i % 2 == 0 ? -1 : 1) * 4.0)),
                    i % 2 == 0 ? 6.0 * i + 8.0 : 6.0 * (i - 1) + 8.0, 1e-9);
    }
}

// Three walls of mirrors show each other 3 * 2^(k - 1) times in k reflections at most; windows leave few.
TEST(MirroredViews, OfMirrorsThatFaceEachOtherAreBounded) {
    const std::vector<PlaneMirror> box = {
        rectangle({-2, -2, -2}, {4, 0, 0}, {0, 4, 0}), rectangle({-2, -2, 2}, {4, 0, 0}, {0, 4, 0}),
        rectangle({-2, -2, -2}, {0, 4, 0}, {0, 0, 4}), rectangle({2, -2, -2}, {0, 4, 0}, {0, 0, 4}),
        rectangle({-2, -2, -2}, {4, 0, 0}, {0, 0, 4}), rectangle({-2, 2, -2}, {4, 0, 0}, {0, 0, 4})};
    const Camera eye = test::look_at({0.3, 0.4, 1}, {0, 0, -2}, 1.0);
    EXPECT_LE(images_of(box, eye, 4).size(), 300u);
    const std::vector<MirroredView> capped = images_of(box, eye, 50, 20);
    ASSERT_EQ(capped.size(), 20u);
    // The same images as without the cap, those of few reflections first.
    const std::vector<MirroredView> more = images_of(box, eye, 50, 40);
    for (std::size_t i = 0; i < capped.size(); ++i) {
        EXPECT_EQ(capped[i].eye.position, more[i].eye.position);
        EXPECT_EQ(capped[i].window, more[i].window);
        if (i == 0) continue;
        EXPECT_GE(capped[i].reflections, capped[i - 1].reflections);
    }
}

}  // namespace
}  // namespace utsuri
