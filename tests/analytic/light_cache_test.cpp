// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces, held against closed forms at the very points where it is kept.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "base/error.h"

#include "filled_light.h"
#include "interop/bindings.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;

class LightCacheOnSurfaces : public DeviceTest {};

/// Counts dispatches: each is told of.
class CountingProgress : public Progress {
  public:
    void update(double /*done*/, double /*total*/) override { ++dispatches_; }
    [[nodiscard]] double dispatches() const { return dispatches_; }

  private:
    double dispatches_ = 0.0;
};

// A floor in the sun takes few rays, and its other side none: dispatches grow to what such points cost. They
// start at 64 points and grow eightfold until one takes 0.1 s; where a machine is slow, one that is not grown
// takes at least an eighth of that.
TEST_F(LightCacheOnSurfaces, PointsThatTakeFewRaysAreSimulatedTogether) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0, -1, 0};
    sun.intensity = glm::vec3(1.0f);
    scene.lights.push_back(sun);
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    LightSettings settings;
    settings.spacing = 1.0 / 300.0;
    settings.refinement = 1.0;
    LightCache cache(device(), data, gpu_scene, settings);
    CountingProgress progress;
    cache.fill(progress);
    const auto points = static_cast<double>(cache.mesh().points.size());
    EXPECT_GT(points, 10000.0);
    const double growing = 1.0 + std::log(points / 64.0) / std::log(8.0);
    EXPECT_LE(progress.dispatches(), std::ceil(growing) + cache.cost().counts.gpu_seconds / (0.1 / 8.0));
}

// One light, no chance: E cos / pi on the side it shines on, nothing on the other.
TEST_F(LightCacheOnSurfaces, SunOnAFloor) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.5f)));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0.6, -0.8, 0.0};
    sun.intensity = {3.0f, 2.0f, 1.0f};
    scene.lights.push_back(sun);
    const Filled filled = fill(device(), scene, evenly_kept(0.05, 4, 3));
    int visited = 0;
    for_each_point(filled, [&](std::size_t, const glm::dvec3&, const interop::LightMeshPoint& point) {
        ++visited;
        for (int c = 0; c < 3; ++c) {
            const double expected = static_cast<double>(sun.intensity[c]) * 0.8 / kPi;
            EXPECT_NEAR(static_cast<double>(point.front[c]), expected, kRounding * expected);
            EXPECT_EQ(point.back[c], 0.0f);
        }
    });
    EXPECT_GT(visited, 400);
    EXPECT_GE(filled.counts.rays, filled.mesh.points.size());
}

/// Where the device's atan() is the least exact part: 4096 ulp are allowed, 1e-5 is what devices have.
constexpr double kTrigonometry = 1e-4;

/// Terms of up to 1 that cancel in Lambert's contour integral, over pi: some 30 roundings.
constexpr double kContour = 6e-7;

const std::array<glm::dvec3, 4> kSquare = {
    glm::dvec3{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}};

// Lambert's formula under a square of radiance 1, at every point on the floor: where nothing is in shadow
// there is no chance in it.
TEST_F(LightCacheOnSurfaces, SquareOverAFloor) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const Filled filled = fill(device(), scene, evenly_kept(0.04, 16, 3));
    int count = 0;
    for_each_point(
        filled, [&](std::size_t, const glm::dvec3& position, const interop::LightMeshPoint& point) {
            if (std::abs(position.y) > 1e-6) return;
            const double expected = std::abs(polygon_irradiance(kSquare, position, {0, 1, 0})) / kPi;
            EXPECT_NEAR(static_cast<double>(point.front.x), expected, kTrigonometry * expected);
            EXPECT_EQ(point.back, glm::vec3(0.0f));
            ++count;
        });
    ASSERT_GT(count, 500);
}

// A wall through the plane of a square light sees the part of it that is above its horizon.
TEST_F(LightCacheOnSurfaces, SquareCutByTheHorizon) {
    Scene scene;
    add(scene, quad({0.2f, -1, 0.8f}, {0, 0.9f, 0}, {0, 0, -1.6f}), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const Filled filled = fill(device(), scene, evenly_kept(0.04, 16, 3));
    const std::array<glm::dvec3, 4> left = {
        glm::dvec3{-0.5, 1, -0.5}, {0.2, 1, -0.5}, {0.2, 1, 0.5}, {-0.5, 1, 0.5}};
    const std::array<glm::dvec3, 4> right = {
        glm::dvec3{0.2, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {0.2, 1, 0.5}};
    int count = 0;
    for_each_point(filled, [&](std::size_t t, const glm::dvec3& position,
                               const interop::LightMeshPoint& point) {
        if (position.y > 0.0) return;
        const interop::BvhTriangle& triangle = filled.data.bvh.triangles[t];
        const bool front_is_left = glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0).x < 0.0f;
        const double lit_left = std::abs(polygon_irradiance(left, position, {-1, 0, 0})) / kPi;
        const double lit_right = std::abs(polygon_irradiance(right, position, {1, 0, 0})) / kPi;
        const double front = front_is_left ? lit_left : lit_right;
        const double back = front_is_left ? lit_right : lit_left;
        EXPECT_NEAR(static_cast<double>(point.front.x), front, kTrigonometry * front + kContour);
        EXPECT_NEAR(static_cast<double>(point.back.x), back, kTrigonometry * back + kContour);
        ++count;
    });
    ASSERT_GT(count, 200);
}

// A blocker half way up hides from every point what it covers as seen from there; in its penumbra samples
// tell what share that is. 256 of them are spread evenly over the light: the share is wrong by at most what
// its edge crosses of their strata, 2 of 16 columns.
TEST_F(LightCacheOnSurfaces, PenumbraOfABlocker) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    add(scene, quad({0, 0.5f, -3}, {3, 0, 0}, {0, 0, 6}), mirror());
    const Filled filled = fill(device(), scene, evenly_kept(0.04, 256, 3));
    int in_penumbra = 0;
    for_each_point(filled,
                   [&](std::size_t, const glm::dvec3& position, const interop::LightMeshPoint& point) {
                       if (std::abs(position.y) > 1e-6) return;
                       // The blocker's edge x = 0, z any, at half the height is seen against x = -position.x.
                       const double edge = std::clamp(-position.x, -0.5, 0.5);
                       std::array<glm::dvec3, 4> seen = kSquare;
                       seen[1].x = seen[2].x = edge;
                       const double whole = std::abs(polygon_irradiance(kSquare, position, {0, 1, 0})) / kPi;
                       const double expected =
                           edge > -0.5 ? std::abs(polygon_irradiance(seen, position, {0, 1, 0})) / kPi : 0.0;
                       if (edge > -0.5 && edge < 0.5) ++in_penumbra;
                       EXPECT_NEAR(static_cast<double>(point.front.x), expected, 2.0 / 16.0 * whole)
                           << position.x << ' ' << position.z;
                   });
    EXPECT_GT(in_penumbra, 50);
}

// The floor of a closed box, whose walls meet it, gets nothing from a light outside.
TEST_F(LightCacheOnSurfaces, ClosedBoxStaysDark) {
    Scene scene;
    const std::uint32_t box = add(scene, room({-1, -1, -1}, {1, 1, 1}), lambert(glm::vec3(0.7f)));
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {0.3, 2.5, 0.2};
    lamp.intensity = glm::vec3(100.0f);
    scene.lights.push_back(lamp);
    const Filled filled = fill(device(), scene, evenly_kept(0.03, 1, 3));
    bool lit_outside = false;
    for_each_point(filled, [&](std::size_t t, const glm::dvec3&, const interop::LightMeshPoint& point) {
        ASSERT_EQ(filled.data.triangle_infos[t].instance, box);
        EXPECT_EQ(point.front, glm::vec3(0.0f));
        lit_outside = lit_outside || point.back.x > 0.0f;
    });
    EXPECT_TRUE(lit_outside);
}

TEST_F(LightCacheOnSurfaces, SameForAnySplitOfTheWork) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    const Filled first = fill(device(), scene, {0.1, 200, 3});
    // A dispatch of less than a workgroup, whose last one is not full.
    const Filled second = fill(device(), scene, {0.1, 200, 3, 7});
    ASSERT_EQ(first.mesh.points.size(), second.mesh.points.size());
    for (std::size_t i = 0; i < first.mesh.points.size(); ++i) {
        EXPECT_EQ(first.mesh.points[i].front, second.mesh.points[i].front);
        EXPECT_EQ(first.mesh.points[i].back, second.mesh.points[i].back);
    }
}

/// The sun, straight down.
Light noon() {
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0, -1, 0};
    sun.intensity = glm::vec3(1.0f);
    return sun;
}

// Smooth Lambert: at the corners of facets, by the normals that are interpolated there, not by those of the
// facets, which are up to 11 degrees off.
TEST_F(LightCacheOnSurfaces, SunOnACoarseSmoothBall) {
    Scene scene;
    add(scene, icosphere({0, 0, 0}, 1.0f, 2), lambert(glm::vec3(0.5f)));
    scene.lights.push_back(noon());
    const Filled filled = fill(device(), scene, evenly_kept(1.0, 4, 3));
    int lit = 0;
    int dark = 0;
    for_each_point(filled,
                   [&](std::size_t, const glm::dvec3& position, const interop::LightMeshPoint& point) {
                       const double cosine = position.y / glm::length(position);
                       // Facets at the terminator hide the light from each other.
                       if (std::abs(cosine) < 0.25) return;
                       ++(cosine > 0.0 ? lit : dark);
                       const double expected = std::max(cosine, 0.0) / kPi;
                       EXPECT_NEAR(static_cast<double>(point.front.x), expected, 8.0 * kRounding);
                   });
    EXPECT_GT(lit, 100);
    EXPECT_GT(dark, 100);
}

// What lies above both horizons, of the surface and of its interpolated normal. The sphere of directions is
// uniform: half an ellipse of it is left when projected (see environment_irradiance()), or a panel so large
// that it is nearly that.
TEST_F(LightCacheOnSurfaces, SurroundingsOfABallWithSmoothNormals) {
    Scene scene;
    add(scene, icosphere({0, 0, 0}, 1.0f, 1), lambert(glm::vec3(0.5f)));
    scene.environment = glm::vec3(1.0f);
    const Filled filled = fill(device(), scene, evenly_kept(1.0, 4, 3));
    int count = 0;
    for (std::uint32_t t = 0; t < filled.data.triangle_infos.size(); ++t) {
        const Corners corners = corners_of(filled.data, t);
        const glm::dvec3 ng = glm::normalize(doubled_area(corners));
        for_each_leaf(
            filled.mesh, t, corners, [&](const Corners& leaf, const std::array<std::uint32_t, 3>& points) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const double cosine = glm::dot(ng, glm::normalize(filled.data.origin + leaf[i]));
                    // Corners are shared, and each of their triangles cuts as much of the surroundings off.
                    const double expected = 0.5 * (1.0 + cosine);
                    EXPECT_NEAR(static_cast<double>(filled.mesh.points[points[i]].front.x), expected, 0.02);
                    ++count;
                }
            });
    }
    EXPECT_GT(count, 200);
}

/// A square light over the ground, dark by its texture up to a share of its width.
Scene partly_dark_light(float height, int dark_of_64) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    Texture texture;
    texture.width = 64;
    texture.height = 4;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 64; ++x) {
            const std::uint8_t byte = x < dark_of_64 ? 0 : 255;
            texture.rgba.insert(texture.rgba.end(), {byte, byte, byte, 255});
        }
    }
    scene.textures.push_back(texture);
    Mesh light = quad({-0.5f, height, -0.5f}, {1, 0, 0}, {0, 0, 1});
    light.texcoords.clear();
    for (const glm::vec3& position : light.positions)
        light.texcoords.emplace_back(position.x + 0.5f, position.z + 0.5f);
    Material shines = emitter(glm::vec3(1.0f));
    shines.emissive_texture.texture = 0;
    shines.emissive_texture.filter = TextureFilter::nearest;
    add(scene, light, shines);
    return scene;
}

// Lambert's formula for the part that shines. What is near is lit by pieces, 1/8 of an edge long: their
// borders are those of the dark part in one case, and in the other it ends in the middle of pieces, which act
// as if they shone evenly and have to be a few times their length away.
TEST_F(LightCacheOnSurfaces, LightThatIsPartlyDarkByItsTexture) {
    struct Case {
        float height;
        int dark_of_64;
    };
    for (const auto& [height, dark_of_64] : {Case{0.05f, 32}, {0.5f, 32}, {1.0f, 20}, {3.0f, 20}}) {
        const Filled filled = fill(device(), partly_dark_light(height, dark_of_64), evenly_kept(0.04, 16, 3));
        const auto y = static_cast<double>(height);
        const double left = dark_of_64 / 64.0 - 0.5;
        const std::array<glm::dvec3, 4> bright = {
            glm::dvec3{left, y, -0.5}, {0.5, y, -0.5}, {0.5, y, 0.5}, {left, y, 0.5}};
        int count = 0;
        for_each_point(
            filled, [&](std::size_t, const glm::dvec3& position, const interop::LightMeshPoint& point) {
                if (std::abs(position.y) > 1e-6) return;
                const double expected = std::abs(polygon_irradiance(bright, position, {0, 1, 0})) / kPi;
                EXPECT_NEAR(static_cast<double>(point.front.x), expected, 0.01 * expected + 1e-5)
                    << height << ": " << position.x << ' ' << position.z;
                ++count;
            });
        ASSERT_GT(count, 300);
    }
}

/// A hut of thin walls without a floor, on ground that goes on outside, turned off all axes.
Scene hut_on_the_ground() {
    Scene scene;
    add(scene, ground(4.0f), lambert(glm::vec3(0.5f)));
    const std::array walls = {block({-1, 0, -1}, {-0.99f, 2, 1}), block({0.99f, 0, -1}, {1, 2, 1}),
                              block({-1, 0, -1}, {1, 2, -0.99f}), block({-1, 0, 0.99f}, {1, 2, 1}),
                              block({-1, 1.99f, -1}, {1, 2, 1})};
    for (const Mesh& wall : walls)
        add(scene, wall, lambert(glm::vec3(0.5f)));
    Light sun = noon();
    const glm::dmat4 slanted =
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3.3, -1.7, 2.2)), 0.7, glm::dvec3(1, 2, 3));
    sun.direction = glm::dvec3(slanted * glm::dvec4(sun.direction, 0.0));
    scene.lights.push_back(sun);
    for (Instance& instance : scene.instances)
        instance.world_from_object = slanted;
    return scene;
}

// Everywhere on the ground, not only at points: inside it is dark, and outside light right up to the walls,
// which the sun from above leaves in no shadow.
TEST_F(LightCacheOnSurfaces, NoneAcrossAWallAndNoneLostBesideIt) {
    const Scene scene = hut_on_the_ground();
    const glm::dmat4 upright = glm::inverse(scene.instances[0].world_from_object);
    for (const double spacing : {0.2, 0.02}) {
        const Filled filled = fill(device(), scene, evenly_kept(spacing, 8, 3));
        int inside = 0;
        int outside = 0;
        for (std::uint32_t t = 0; t < filled.data.triangle_infos.size(); ++t) {
            if (filled.data.triangle_infos[t].instance != 0) continue;
            for_each_leaf(filled.mesh, t, corners_of(filled.data, t),
                          [&](const Corners& leaf, const std::array<std::uint32_t, 3>& points) {
                              const glm::dvec3 middle = (leaf[0] + leaf[1] + leaf[2]) / 3.0;
                              const glm::dvec3 at(upright * glm::dvec4(filled.data.origin + middle, 1.0));
                              const double from_middle = std::max(std::abs(at.x), std::abs(at.z));
                              if (from_middle > 0.99 && from_middle < 1.0) return;  // under the walls
                              const double expected = from_middle < 1.0 ? 0.0 : 1.0 / kPi;
                              ++(from_middle < 1.0 ? inside : outside);
                              for (const std::uint32_t point : points)
                                  EXPECT_NEAR(static_cast<double>(filled.mesh.points[point].front.x),
                                              expected, 8.0 * kRounding)
                                      << at.x << ' ' << at.z;
                          });
        }
        EXPECT_GE(inside, 2);
        EXPECT_GE(outside, 8);
    }
}

// Half in the shade of a board: what lies between points is off by less where they are denser.
TEST_F(LightCacheOnSurfaces, IsDenserWhereAShadowEnds) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.5f)));
    add(scene, quad({-3, 1, -3}, {0, 0, 6}, {3.1f, 0, 0}), mirror());
    scene.lights.push_back(noon());
    const Filled even = fill(device(), scene, evenly_kept(0.1, 4, 3));
    LightSettings settings = evenly_kept(0.1, 4, 3);
    settings.refinement = 16.0;
    const Filled fine = fill(device(), scene, settings);
    const auto area_in_doubt = [](const Filled& filled) {
        double area = 0.0;
        for (std::uint32_t t = 0; t < filled.data.triangle_infos.size(); ++t) {
            for_each_leaf(filled.mesh, t, corners_of(filled.data, t),
                          [&](const Corners& leaf, const std::array<std::uint32_t, 3>& points) {
                              const auto light = [&](std::size_t i) {
                                  return filled.mesh.points[points[i]].front.x;
                              };
                              if (light(0) == light(1) && light(1) == light(2)) return;
                              area += 0.5 * glm::length(glm::cross(leaf[1] - leaf[0], leaf[2] - leaf[0]));
                          });
        }
        return area;
    };
    EXPECT_LT(area_in_doubt(fine), area_in_doubt(even) / 8.0);
    EXPECT_LT(fine.mesh.points.size(), 16u * even.mesh.points.size());
}

}  // namespace
}  // namespace utsuri::test
