// SPDX-License-Identifier: Apache-2.0
// Light kept under several lamps: each is summed in closed form, and the shadow of one is no matter of the
// others.
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "filled_light.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// As far as devices' square roots and quotients are exact: see light_cache_test.cpp.
constexpr double kTrigonometry = 1e-4;

/// What acts as a point is no larger than 1/8 of its distance: (1/8)^2 / 4, see unshadowed_light.glsl.
constexpr double kActsAsPoint = 1.0 / 256.0;

std::vector<glm::dvec3> square(const glm::dvec3& centre, double half) {
    return {centre + glm::dvec3(-half, 0, -half), centre + glm::dvec3(half, 0, -half),
            centre + glm::dvec3(half, 0, half), centre + glm::dvec3(-half, 0, half)};
}

/// The outside of a tube along x, open at its ends, of twelve sides.
Mesh long_tube(float radius, float height, float half_length) {
    constexpr std::uint32_t kSides = 12;
    Mesh mesh;
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const double angle = 2.0 * kPi * side / kSides;
        const glm::vec3 out(0.0, std::cos(angle), std::sin(angle));
        for (const float x : {-half_length, half_length}) {
            mesh.positions.push_back(glm::vec3(x, height, 0.0f) + radius * out);
            mesh.normals.push_back(out);
            mesh.texcoords.emplace_back(0.0f);
        }
        const std::uint32_t a = 2 * side;
        const std::uint32_t b = 2 * ((side + 1) % kSides);
        mesh.triangles.emplace_back(a, b, a + 1);
        mesh.triangles.emplace_back(a + 1, b, b + 1);
    }
    return mesh;
}

/// Irradiance on the ground from the triangles of a convex lamp that face the point, each of radiance 1.
double irradiance_of_facing(const Mesh& lamp, const glm::dvec3& position) {
    double sum = 0.0;
    for (const glm::uvec3& triangle : lamp.triangles) {
        const std::array<glm::dvec3, 3> corners = {lamp.positions[triangle.x], lamp.positions[triangle.y],
                                                   lamp.positions[triangle.z]};
        const glm::dvec3 out = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (glm::dot(out, position - corners[0]) > 0.0)
            sum += std::abs(polygon_irradiance(corners, position, {0, 1, 0}));
    }
    return sum;
}

class LampShadows : public DeviceTest {
  protected:
    /// Holds light on the ground, the first instance at y = 0, against what is expected at each place as far
    /// as `most_x` from the middle.
    static void expect_on_ground(const Scene& scene, std::uint32_t samples, double tolerance,
                                 const std::function<double(const glm::dvec3&)>& expected,
                                 double most_x = 1.0) {
        const Filled filled = fill(device(), scene, evenly_kept(0.04, samples, 3));
        int count = 0;
        for_each_point(filled,
                       [&](std::size_t t, const glm::dvec3& position, const interop::LightMeshPoint& point) {
                           if (filled.data.triangle_infos[t].instance != 0 || std::abs(position.x) > most_x)
                               return;
                           const double there = expected(position);
                           EXPECT_NEAR(static_cast<double>(point.front.x), there, tolerance * there)
                               << position.x << ' ' << position.z;
                           ++count;
                       });
        EXPECT_GT(count, 500);
    }
};

// Beside a lamp a thousand times as bright that is shut in a box, no ray tells anything of the lamp that is
// not in shadow: it lights by Lambert's formula.
TEST_F(LampShadows, AHiddenLampIsNoMatterOfOthers) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
    add(scene, ceiling({4, 1, 0}, 0.5f), emitter(glm::vec3(1000.0f)));
    add(scene, block({3.4f, 0.5f, -0.6f}, {4.6f, 1.5f, 0.6f}), lambert(glm::vec3(0.5f)));
    const std::vector<glm::dvec3> panel = square({0, 1, 0}, 0.5);
    expect_on_ground(scene, 64, kTrigonometry, [&](const glm::dvec3& position) {
        return std::abs(polygon_irradiance(panel, position, {0, 1, 0})) / kPi;
    });
}

// A bulb of 1,280 triangles, of which each point sees half: near ones by Lambert's formula, far ones as
// points, none by chance.
TEST_F(LampShadows, ABulbOfManyTrianglesLightsWithoutNoise) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    const Mesh bulb = icosphere({0, 0.4f, 0}, 0.2f, 3);
    add(scene, bulb, emitter(glm::vec3(1.0f)));
    expect_on_ground(scene, 64, kActsAsPoint,
                     [&](const glm::dvec3& position) { return irradiance_of_facing(bulb, position) / kPi; });
}

// A fluorescent tube of 24 triangles 0.9 m long, 17 mm above the ground, which shine both ways: its far half
// is hidden by its near one. What a point sees of it is a few centimetres, where samples have to be. A
// sample's relative variance is below 1, so that four standard errors of 256 samples are a quarter.
TEST_F(LampShadows, ALampNearerThanItIsLong) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    Material light = emitter(glm::vec3(1.0f));
    light.double_sided = true;
    const Mesh tube = long_tube(0.013f, 0.03f, 0.45f);
    add(scene, tube, light);
    expect_on_ground(
        scene, 256, 4.0 / 16.0,
        [&](const glm::dvec3& position) { return irradiance_of_facing(tube, position) / kPi; },
        0.4);  // from beyond its ends one sees into it
}

// A plate that shines both ways, and a bulb, askew and off the middle of the scene, so that no coordinate is
// round: a point on a lamp may lie a rounding above it, where half of the sky would shine.
TEST_F(LampShadows, LampsThatBulgeNowhereInwardsDoNotLightThemselves) {
    Material light = lambert(glm::vec3(0.5f));
    light.emissive = glm::vec3(1.0f);
    light.double_sided = true;
    const glm::dmat4 askew = glm::rotate(glm::translate(glm::dmat4(1.0), {0.7, 1.3, -0.4}), 1.1,
                                         glm::normalize(glm::dvec3(0.3, 0.7, -0.5)));
    for (const Mesh& lamp : {ceiling({0, 0, 0}, 0.3f), icosphere({0, 0, 0}, 0.2f, 2)}) {
        Scene scene;
        add(scene, lamp, light);
        scene.instances.back().world_from_object = askew;
        add(scene, ground(8.0f), lambert(glm::vec3(0.0f)));
        const Filled filled = fill(device(), scene, evenly_kept(0.005, 64, 3));
        int count = 0;
        for_each_point(filled, [&](std::size_t t, const glm::dvec3&, const interop::LightMeshPoint& point) {
            if (filled.data.triangle_infos[t].instance != 0) return;
            EXPECT_LE(point.front.x, kActsAsPoint);
            const bool is_plate = lamp.triangles.size() == 2;  // the inside of a bulb shines on itself
            EXPECT_LE(is_plate ? point.back.x : 0.0f, kActsAsPoint);
            ++count;
        });
        EXPECT_GT(count, 100);
    }
}

// More triangles than are summed: by samples alone. A sample's relative variance is below 1, so that four
// standard errors of 256 samples are a quarter.
TEST_F(LampShadows, TooManyTrianglesToSum) {
    Scene scene;
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    Mesh panel;
    constexpr int kEdge = 48;
    for (int i = 0; i < kEdge * kEdge; ++i) {
        const float half = 0.5f / kEdge;
        const glm::vec3 centre(-0.5f + half * static_cast<float>(2 * (i % kEdge) + 1), 1.0f,
                               -0.5f + half * static_cast<float>(2 * (i / kEdge) + 1));
        const Mesh part = ceiling(centre, half);
        const auto first = static_cast<std::uint32_t>(panel.positions.size());
        for (const glm::uvec3& triangle : part.triangles)
            panel.triangles.push_back(triangle + first);
        panel.positions.insert(panel.positions.end(), part.positions.begin(), part.positions.end());
        panel.normals.insert(panel.normals.end(), part.normals.begin(), part.normals.end());
        panel.texcoords.insert(panel.texcoords.end(), part.texcoords.begin(), part.texcoords.end());
    }
    add(scene, panel, emitter(glm::vec3(1.0f)));
    const std::vector<glm::dvec3> whole = square({0, 1, 0}, 0.5);
    expect_on_ground(scene, 256, 4.0 / 16.0, [&](const glm::dvec3& position) {
        return std::abs(polygon_irradiance(whole, position, {0, 1, 0})) / kPi;
    });
}

}  // namespace
}  // namespace utsuri::test
