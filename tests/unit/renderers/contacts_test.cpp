// SPDX-License-Identifier: Apache-2.0
// What touches or crosses a triangle.
#include "renderers/light/mesh/contacts.h"

#include "renderers/device_scene/scene_triangles.h"
#include "support/light_scenes.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace utsuri::test {
namespace {

/// Turned off all axes, so that every coordinate is rounded.
glm::dmat4 slanted() {
    return glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, -0.7, 0.2)), 0.7, glm::dvec3(1, 2, 3));
}

/// A floor of 4 m by 4 m, instance 0, and a thing on it, instance 1.
SceneData floor_with(const Mesh& thing) {
    Scene scene;
    add(scene, quad({-2, 0, -2}, {0, 0, 4}, {4, 0, 0}), lambert(glm::vec3(0.5f)));
    add(scene, thing, lambert(glm::vec3(0.5f)));
    for (Instance& instance : scene.instances)
        instance.world_from_object = slanted() * instance.world_from_object;
    return prepare_scene_data(scene);
}

constexpr double kGap = 0.005;

/// Lines on all triangles of an instance, in the coordinates of the floor: x and z.
std::vector<ContactSegment> lines_on(const SceneData& data, std::uint32_t instance) {
    const ContactFinder finder(data, kGap);
    const glm::dmat4 upright = glm::inverse(slanted());
    std::vector<ContactSegment> lines;
    for (const std::uint32_t triangle : triangles_of(data, instance)) {
        const Corners corners = corners_of(data, triangle);
        const glm::dvec3 right = glm::normalize(corners[1] - corners[0]);
        const glm::dvec3 up = glm::normalize(glm::cross(doubled_area(corners), right));
        const auto on_floor = [&](const glm::dvec2& p) {
            const glm::dvec4 at =
                upright * glm::dvec4(data.origin + corners[0] + p.x * right + p.y * up, 1.0);
            return glm::dvec2(at.x, at.z);
        };
        for (const ContactSegment& line : finder.find(triangle))
            lines.push_back({on_floor(line.from), on_floor(line.to)});
    }
    return lines;
}

double length(const ContactSegment& line) {
    return glm::distance(line.from, line.to);
}

double total_length(const std::vector<ContactSegment>& lines) {
    double sum = 0.0;
    for (const ContactSegment& line : lines)
        sum += length(line);
    return sum;
}

/// Coordinates of a few metres, each rounded some times.
constexpr double kMetres = 1e-5;

TEST(Contacts, OfABoxAreItsOutline) {
    const SceneData data = floor_with(block({-0.5f, 0, -0.25f}, {0.5f, 1, 0.25f}));
    const std::vector<ContactSegment> lines = lines_on(data, 0);
    EXPECT_NEAR(total_length(lines), 3.0, 8 * kMetres);
    for (const ContactSegment& line : lines) {
        const bool along_x =
            std::abs(std::abs(line.from.x) - 0.5) < kMetres && std::abs(line.from.x - line.to.x) < kMetres;
        const bool along_z =
            std::abs(std::abs(line.from.y) - 0.25) < kMetres && std::abs(line.from.y - line.to.y) < kMetres;
        EXPECT_TRUE(along_x || along_z) << line.from.x << ' ' << line.from.y;
    }
}

TEST(Contacts, OfABoxThroughTheFloorAreItsOutline) {
    const SceneData data = floor_with(block({-0.5f, -1, -0.25f}, {0.5f, 1, 0.25f}));
    EXPECT_NEAR(total_length(lines_on(data, 0)), 3.0, 16 * kMetres);
}

// Nearer than the gap; the lid is as near, so that top and bottom have an outline each, and the rim's
// diagonals run between them.
TEST(Contacts, OfAMatJustAboveTheFloorAreItsOutlines) {
    const SceneData data = floor_with(block({-0.5f, 0.001f, -0.25f}, {0.5f, 0.003f, 0.25f}));
    const double found = total_length(lines_on(data, 0));
    EXPECT_GE(found, 3.0 - kMetres);
    EXPECT_LE(found, 9.0 + 16 * kMetres);
}

TEST(Contacts, OfASheetOnTheFloorAreItsOutline) {
    const SceneData data = floor_with(quad({-0.5f, 0, -0.25f}, {0, 0, 0.5f}, {1, 0, 0}));
    EXPECT_NEAR(total_length(lines_on(data, 0)), 3.0, 8 * kMetres);
}

TEST(Contacts, AreNotMadeByWhatHangsAboveTheGap) {
    const SceneData data = floor_with(block({-0.5f, 0.006f, -0.25f}, {0.5f, 1, 0.25f}));
    EXPECT_TRUE(lines_on(data, 0).empty());
}

TEST(Contacts, AreNotMadeByNeighboursInOneSurface) {
    const SceneData ball = floor_with(icosphere({0, 1, 0}, 0.5f, 3));
    EXPECT_TRUE(lines_on(ball, 1).empty());
    EXPECT_TRUE(lines_on(ball, 0).empty()) << "the floor's own halves";
}

// The floor's halves share their diagonal; with a wall on it there are three.
TEST(Contacts, AreMadeByAWallOnAnEdgeOfTheMesh) {
    const SceneData data = floor_with(quad({-2, 0, -2}, {4, 0, 4}, {0, 1, 0}));
    const std::vector<ContactSegment> lines = lines_on(data, 0);
    EXPECT_NEAR(total_length(lines), 2.0 * std::sqrt(32.0), 8 * kMetres);
}

TEST(Contacts, AreClippedToTheTriangle) {
    const std::array<glm::dvec2, 3> corners = {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
    const auto across = clip_to_triangle({{-1, 0.25}, {3, 0.25}}, corners, 0.0);
    ASSERT_TRUE(across);
    EXPECT_NEAR(across->from.x, 0.0, 1e-12);
    EXPECT_NEAR(across->to.x, 0.75, 1e-12);
    const auto inside = clip_to_triangle({{0.2, 0.2}, {0.3, 0.4}}, corners, 0.0);
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->from, glm::dvec2(0.2, 0.2));
    EXPECT_EQ(inside->to, glm::dvec2(0.3, 0.4));
    EXPECT_FALSE(clip_to_triangle({{-1, -0.1}, {3, -0.1}}, corners, 0.0));
    EXPECT_TRUE(clip_to_triangle({{-1, -0.1}, {3, -0.1}}, corners, 0.2));
    EXPECT_FALSE(clip_to_triangle({{0.9, 0.9}, {0.6, 0.6}}, corners, 0.0));
}

}  // namespace
}  // namespace utsuri::test
