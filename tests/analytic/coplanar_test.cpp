// SPDX-License-Identifier: Apache-2.0
// Surfaces that overlap in one plane: the smaller one shows, in every method and from every eye.
#include "renderers/device_scene/coplanar_layers.h"
#include "renderers/film/frame_camera.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <optional>
#include <random>

namespace utsuri::test {
namespace {

constexpr glm::vec3 kRoom = {0.3f, 0.5f, 0.2f};
constexpr glm::vec3 kWall = {0.0f, 0.0f, 1.0f};
constexpr glm::vec3 kPicture = {1.0f, 0.0f, 0.0f};
constexpr glm::vec3 kSticker = {0.0f, 1.0f, 0.0f};
constexpr RenderSettings kFrame{48, 36, 3, 4};

/// A rectangle in the plane z = 0, before all is turned, and what it shows.
struct Sheet {
    glm::dvec2 lower;
    glm::dvec2 upper;
    glm::vec3 colour;  ///< of a mirror that of the room
    bool is_mirror;
};
/// From the top down, on both sides.
constexpr Sheet kSheets[] = {{{-0.3, -0.2}, {0.1, 0.1}, kSticker, false},
                             {{0.7, -0.6}, {1.5, 0.5}, kRoom, true},
                             {{-0.9, -0.7}, {0.4, 0.6}, kPicture, false},
                             {{-2.0, -1.5}, {2.0, 1.5}, kWall, false}};

/// How the plane lies in the room.
struct Pose {
    glm::dquat turn;
    glm::dvec3 move;

    [[nodiscard]] glm::dvec3 of(const glm::dvec3& point) const { return turn * point + move; }
    [[nodiscard]] glm::dvec3 back(const glm::dvec3& point) const {
        return glm::conjugate(turn) * (point - move);
    }
};

/// Each corner is turned and rounded by itself, as an exporter does.
Mesh turned(const Sheet& sheet, const Pose& pose) {
    const auto at = [&](double x, double y) { return glm::vec3(pose.of({x, y, 0.0})); };
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.positions = {at(sheet.lower.x, sheet.lower.y), at(sheet.upper.x, sheet.lower.y),
                      at(sheet.upper.x, sheet.upper.y), at(sheet.lower.x, sheet.upper.y)};
    mesh.normals.assign(4, glm::vec3(pose.turn * glm::dvec3(0, 0, 1)));
    return mesh;
}

/// @param wall_first the order of the file
Scene hung_pictures(const Pose& pose, bool wall_first) {
    Scene scene;
    add(scene, room(glm::vec3(-6.0f), glm::vec3(6.0f)), emitter(kRoom));
    std::vector<Sheet> sheets(std::begin(kSheets), std::end(kSheets));
    if (wall_first) std::reverse(sheets.begin(), sheets.end());
    for (const Sheet& sheet : sheets) {
        Material material = sheet.is_mirror ? mirror() : emitter(sheet.colour);
        material.double_sided = true;
        add(scene, turned(sheet, pose), material);
    }
    return scene;
}

/// The sheet at a point of the plane, or none.
const Sheet* sheet_at(const glm::dvec2& point) {
    for (const Sheet& sheet : kSheets) {
        if (glm::all(glm::greaterThan(point, sheet.lower)) && glm::all(glm::lessThan(point, sheet.upper)))
            return &sheet;
    }
    return nullptr;
}

/// What all of a pixel shows; none where that is an edge's.
std::optional<glm::vec3> colour_of_pixel(const interop::CameraInfo& camera, const glm::dvec3& eye,
                                         const Pose& pose, std::uint32_t x, std::uint32_t y) {
    const glm::dvec3 from = pose.back(eye);
    std::optional<glm::vec3> colour;
    // More than the pixel: samples lie anywhere in it, and rasterisers move edges a little. A sheet that is
    // seen nearly from its edge is thinner than a pixel.
    constexpr int kPoints = 12;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const glm::dvec2 place = -0.25 + 1.5 * glm::dvec2(i % kPoints, i / kPoints) / (kPoints - 1.0);
        const double right = 2.0 * (x + place.x) / kFrame.width - 1.0;
        const double up = 1.0 - 2.0 * (y + place.y) / kFrame.height;
        const glm::dvec3 way =
            glm::conjugate(pose.turn) *
            (glm::dvec3(camera.forward) + right * glm::dvec3(camera.right) + up * glm::dvec3(camera.up));
        const double t = -from.z / way.z;
        const Sheet* sheet = t > 0.0 ? sheet_at(glm::dvec2(from + t * way)) : nullptr;
        const glm::vec3 here = sheet != nullptr ? sheet->colour : kRoom;
        if (colour && *colour != here) return std::nullopt;
        colour = here;
    }
    return colour;
}

/// Poses and eyes by chance: on both sides, from two degrees over the plane on.
struct Look {
    Pose pose;
    glm::dvec3 eye;
    glm::dvec3 target;
};
Look random_look(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto any = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
    Look look{{glm::normalize(glm::dquat(uniform(random), any())), any()}, {}, {}};
    glm::dvec3 away(2.5 * uniform(random), 2.5 * uniform(random), 2.0 * uniform(random));
    away.z += std::copysign(0.15, away.z);
    look.eye = look.pose.of(away);
    look.target = look.pose.of({0.4 * uniform(random), 0.3 * uniform(random), 0.0});
    return look;
}

class Coplanar : public DeviceTest {
  protected:
    /// @param any_reflection whether a mirror may show anything but its wall
    /// @returns pixels that show a sheet
    static int expect_right(const Image& image, const Look& look, const glm::dvec3& origin,
                            bool any_reflection = false) {
        const interop::CameraInfo camera =
            make_camera_info(look_at(look.eye, look.target), origin, kFrame.width, kFrame.height);
        int count = 0;
        int wrong = 0;
        for (std::uint32_t y = 0; y < kFrame.height; ++y) {
            for (std::uint32_t x = 0; x < kFrame.width; ++x) {
                const std::optional<glm::vec3> expected = colour_of_pixel(camera, look.eye, look.pose, x, y);
                if (!expected) continue;
                // What a map shows of a room of one colour is that colour but for interpolation.
                const glm::vec3& pixel = image.pixels[y * kFrame.width + x];
                const glm::vec3 off = glm::abs(pixel - *expected);
                const bool is_reflection = any_reflection && *expected == kRoom && pixel.z <= kRoom.z;
                if (std::max({off.x, off.y, off.z}) > 1e-4f && !is_reflection) ++wrong;
                if (*expected != kRoom) ++count;
            }
        }
        EXPECT_EQ(wrong, 0);
        return count;
    }
};

constexpr int kLooks = 24;

TEST_F(Coplanar, RaysMeetWhatLiesOnTop) {
    std::mt19937 random(11);
    int count = 0;
    for (int i = 0; i < kLooks; ++i) {
        SCOPED_TRACE(i);
        const Look look = random_look(random);
        const Scene scene = hung_pictures(look.pose, i % 2 == 0);
        const Image image = trace(device(), scene, look_at(look.eye, look.target), kFrame, 2).image;
        count += expect_right(image, look, prepare_scene_data(scene).origin);
    }
    EXPECT_GT(count, kLooks * 50);
}

TEST_F(Coplanar, EveryDrawingShowsWhatLiesOnTop) {
    MapSettings maps;
    maps.size = 16;
    maps.samples = 1;
    std::mt19937 random(12);
    for (int i = 0; i < kLooks / 3; ++i) {
        const Look look = random_look(random);
        const Scene scene = hung_pictures(look.pose, i % 2 == 0);
        DrawnScene drawn(device(), scene);
        const glm::dvec3 origin = prepare_scene_data(scene).origin;
        for (const DrawnMethod& method : drawn_methods()) {
            SCOPED_TRACE(testing::Message() << i << ' ' << method);
            // Sphere maps are black beside their disc, which interpolation over a polygon may come to.
            expect_right(drawn.render(method, look_at(look.eye, look.target), kFrame, maps, 2).image, look,
                         origin, method.kind == MapKind::sphere);
        }
    }
}

// The lower sheet is later in the buffers of one, the upper in those of the other; nothing shades the picture
// that lies on a wall, and a lamp flush with the ceiling shines into the room.
TEST_F(Coplanar, WhatLiesOnTopIsLitAndShines) {
    std::mt19937 random(13);
    for (const bool wall_first : {false, true}) {
        for (int i = 0; i < 4; ++i) {
            SCOPED_TRACE(i);
            const Look look = random_look(random);
            const Sheet lamp{{-0.5, -0.5}, {0.5, 0.5}, kPicture, false};
            const Sheet ceiling{{-2.0, -2.0}, {2.0, 2.0}, kWall, false};
            const Pose below{look.pose.turn, look.pose.of({0, 0, -1})};
            Scene scene;
            const auto add_ceiling = [&] { add(scene, turned(ceiling, look.pose), lambert(glm::vec3(0))); };
            if (wall_first) add_ceiling();
            Material shines = emitter(glm::vec3(1.0f));
            shines.double_sided = true;
            add(scene, turned(lamp, look.pose), shines);
            if (!wall_first) add_ceiling();
            // A floor a metre below, with a picture of half its width on it.
            const Material grey = lambert(glm::vec3(0.8f));
            add(scene, turned({{-3, -3}, {3, 3}, kWall, false}, below), lambert(glm::vec3(0.1f)));
            add(scene, turned({{-1, -1}, {1, 1}, kWall, false}, below), grey);
            const glm::dvec3 under = below.of({0.0, 0.0, 0.0});
            const Image image =
                trace(device(), scene, look_at(below.of({0.4, 0.3, 0.7}), under, 1e-4), {16, 16, 3, 4}, 64)
                    .image;
            double sum = 0.0;
            for (const glm::vec3& pixel : image.pixels)
                sum += static_cast<double>(pixel.x) / static_cast<double>(image.pixels.size());
            // A unit square at height 1: Lambert's sum. Of 16384 samples the standard error is below
            // 0.6 / sqrt(16384) of it.
            const double expected = 0.752274688 * 0.8 / 3.14159265359;
            EXPECT_NEAR(sum, expected, 4.5 * 0.6 / 128.0 * expected);
        }
    }
}

}  // namespace
}  // namespace utsuri::test
