// SPDX-License-Identifier: Apache-2.0
// Points chosen on a light triangle: where they fall, and the density that they come with, by area from far
// off and by solid angle from near.
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "chi_square.h"
#include "probe.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace utsuri::test {
namespace {

class TriangleLight : public DeviceTest {};

constexpr std::size_t kSamples = 100000;
/// Relative error of a density by area, computed in float32.
constexpr double kPdfError = 1e-5;
/// Cells along an edge.
constexpr std::size_t kEdge = 8;
constexpr std::size_t kCells = kEdge * kEdge;

using Triangle = std::array<glm::dvec3, 3>;
constexpr Triangle kLight = {glm::dvec3(1, 0.5, 2), glm::dvec3(-2, 0.2, 2.5), glm::dvec3(0, 3, 1)};
/// A strip of 2 m, 0.2 mm wide.
constexpr Triangle kThinLight = {glm::dvec3(-1, 0, 2), glm::dvec3(-0.5, 0.0002, 2), glm::dvec3(1, 0, 2)};

glm::dvec3 middle_of(const Triangle& t) {
    return (t[0] + t[1] + t[2]) / 3.0;
}

/// Of the corners as seen from a point: the numerator and denominator of the tangent of half the solid angle
/// (Van Oosterom and Strackee 1983).
glm::dvec2 half_solid_angle(const Triangle& t, const glm::dvec3& from) {
    const glm::dvec3 a = glm::normalize(t[0] - from), b = glm::normalize(t[1] - from),
                     c = glm::normalize(t[2] - from);
    return {std::abs(glm::dot(a, glm::cross(b, c))), 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a)};
}

double solid_angle(const Triangle& t, const glm::dvec3& from) {
    const glm::dvec2 half = half_solid_angle(t, from);
    return 2.0 * std::atan2(half.x, half.y);
}

/// Cell of a point of a triangle among 64 congruent ones, by its barycentric coordinates.
std::size_t cell_of(const glm::dvec2& b) {
    const auto bin = [](double coordinate) {
        return std::min(static_cast<std::size_t>(std::max(coordinate, 0.0) * kEdge), kEdge - 1);
    };
    const std::size_t i = bin(b.x);
    const std::size_t j = bin(b.y);
    const double within = b.x * kEdge - static_cast<double>(i) + b.y * kEdge - static_cast<double>(j);
    // Upright cells of a row come before the upside-down ones; row i has 8 - i and 7 - i of them.
    return i * (2 * kEdge - i) + 2 * std::min(j, kEdge - 1 - i) + (within > 1.0 && i + j + 1 < kEdge ? 1 : 0);
}

glm::dvec3 point_at(const Triangle& light, const glm::dvec2& b) {
    return light[0] + b.x * (light[1] - light[0]) + b.y * (light[2] - light[0]);
}

glm::dvec2 coordinates_of(const Triangle& light, const glm::dvec3& point) {
    const glm::dvec3 u = light[1] - light[0];
    const glm::dvec3 v = light[2] - light[0];
    const glm::dvec3 area = glm::cross(u, v);
    const glm::dvec3 p = point - light[0];
    return glm::dvec2(glm::dot(glm::cross(p, v), area), glm::dot(glm::cross(u, p), area)) /
           glm::dot(area, area);
}

/// The solid angle of each cell.
std::vector<double> cell_angles(const Triangle& light, const glm::dvec3& from) {
    std::vector<double> angles(kCells, 0.0);
    for (std::size_t i = 0; i < kEdge; ++i) {
        for (std::size_t j = 0; i + j < kEdge; ++j) {
            const auto corner = [&](std::size_t k, std::size_t l) { return glm::dvec2(i + k, j + l) / 8.0; };
            const auto add = [&](const std::array<glm::dvec2, 3>& b) {
                const Triangle cell = {point_at(light, b[0]), point_at(light, b[1]), point_at(light, b[2])};
                angles[cell_of((b[0] + b[1] + b[2]) / 3.0)] = solid_angle(cell, from);
            };
            add({corner(0, 0), corner(1, 0), corner(0, 1)});
            if (i + j + 1 < kEdge) add({corner(1, 1), corner(0, 1), corner(1, 0)});
        }
    }
    return angles;
}

/// The light, alone, shining to both sides; with a white texture if asked for.
SceneData light_scene(const Triangle& light, bool textured) {
    Scene scene;
    Mesh mesh = triangle(glm::vec3(light[0]), glm::vec3(light[1]), glm::vec3(light[2]));
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    add(scene, mesh, emitter(glm::vec3(1.0f)));
    scene.materials.back().double_sided = true;
    if (textured) {
        Texture texture;
        texture.width = texture.height = 1;
        texture.rgba = {255, 255, 255, 255};
        scene.textures.push_back(texture);
        scene.materials.back().emissive_texture.texture = 0;
    }
    return prepare_scene_data(scene);
}

std::vector<interop::ProbeOutput> samples_from(Device& device, const SceneData& data,
                                               const glm::dvec3& position, std::uint32_t seed) {
    interop::ProbePush push{};
    push.position = glm::vec3(position - data.origin);
    push.normal = {0, 0, 1};
    push.wo = push.normal;
    return probe(device, data, interop::PROBE_LIGHT, push, random_pairs(kSamples, seed));
}

/// Over solid angle, of points that are uniform over the triangle.
double density_by_area(const glm::dvec3& point, const glm::dvec3& from) {
    const glm::dvec3 area = 0.5 * glm::cross(kLight[1] - kLight[0], kLight[2] - kLight[0]);
    const glm::dvec3 w = point - from;
    return std::pow(glm::length(w), 3.0) / std::abs(glm::dot(area, w));
}

std::vector<double> counts_of(const std::vector<interop::ProbeOutput>& outputs, const SceneData& data) {
    std::vector<double> counts(kCells, 0.0);
    for (const interop::ProbeOutput& output : outputs)
        counts[cell_of(coordinates_of(kLight, glm::dvec3(output.target) + data.origin))] += 1.0;
    return counts;
}

TEST_F(TriangleLight, PointsOnAFarOneAreUniform) {
    const SceneData data = light_scene(kLight, false);
    const glm::dvec3 position(0.1, 0.2, -8);
    const auto outputs = samples_from(device(), data, position, 200);
    double inverse_sum = 0.0;
    for (const interop::ProbeOutput& output : outputs) {
        const glm::dvec3 point = glm::dvec3(output.target) + data.origin;
        const double pdf = density_by_area(point, position);
        ASSERT_NEAR(static_cast<double>(output.pdf), pdf, kPdfError * pdf);
        ASSERT_LE(glm::length(glm::dvec3(output.direction) - glm::normalize(point - position)), 1e-5);
        inverse_sum += 1.0 / pdf;
    }
    const std::vector<double> expected(kCells, static_cast<double>(kSamples) / kCells);
    EXPECT_GE(chi_square_p_value(counts_of(outputs, data), expected), kRejection);
    // The mean of 1 / pdf is the solid angle; its spread is below its mean.
    const double angle = solid_angle(kLight, position);
    EXPECT_NEAR(inverse_sum / kSamples, angle, 4.5 * angle / std::sqrt(static_cast<double>(kSamples)));
}

/// Before its middle, so close that it fills half of what is seen, at a corner, and at a slant.
std::vector<glm::dvec3> near_places() {
    const glm::dvec3 n = glm::normalize(glm::cross(kLight[1] - kLight[0], kLight[2] - kLight[0]));
    const glm::dvec3 middle = middle_of(kLight);
    return {middle + n, middle - 0.01 * n, middle + 0.001 * n, glm::mix(kLight[0], middle, 0.02) + 0.01 * n,
            glm::mix(middle, kLight[1], 1.3) + 0.3 * n};
}

// Unit vectors of float32 span a volume that is off by some 8 roundings, and so is the denominator: half the
// angle is off by as much over both.
double relative_error_of_angle(const glm::dvec3& from) {
    const glm::dvec2 half = half_solid_angle(kLight, from);
    return kPdfError + 8.0 * 0x1p-24 / glm::length(half) / std::atan2(half.x, half.y);
}

TEST_F(TriangleLight, DirectionsToANearOneAreUniform) {
    const SceneData data = light_scene(kLight, false);
    std::uint32_t seed = 210;
    for (const glm::dvec3& position : near_places()) {
        SCOPED_TRACE(testing::Message() << position.x << ' ' << position.y << ' ' << position.z);
        const auto outputs = samples_from(device(), data, position, seed++);
        const double angle = solid_angle(kLight, position);
        const double allowed = relative_error_of_angle(position) / angle;
        for (const interop::ProbeOutput& output : outputs)
            ASSERT_NEAR(static_cast<double>(output.pdf), 1.0 / angle, allowed);
        std::vector<double> expected = cell_angles(kLight, position);
        for (double& cell : expected)
            cell *= static_cast<double>(kSamples) / angle;
        EXPECT_GE(chi_square_p_value(counts_of(outputs, data), expected), kRejection);
    }
}

// Half by solid angle and half by area, wherever bright texels are. The density by area goes with the height
// over the light, of at least 1e-3, which float32 knows to some units of 2^-22.
TEST_F(TriangleLight, PointsOnANearOneWithATextureAreOfBothKinds) {
    constexpr double kFacingError = 4.0 * 0x1p-22 / 1e-3;
    const SceneData data = light_scene(kLight, true);
    std::uint32_t seed = 220;
    for (const glm::dvec3& position : near_places()) {
        SCOPED_TRACE(testing::Message() << position.x << ' ' << position.y << ' ' << position.z);
        const auto outputs = samples_from(device(), data, position, seed++);
        const double angle = solid_angle(kLight, position);
        std::vector<double> expected = cell_angles(kLight, position);
        for (double& cell : expected)
            cell = static_cast<double>(kSamples) * (0.5 * cell / angle + 0.5 / kCells);
        EXPECT_GE(chi_square_p_value(counts_of(outputs, data), expected), kRejection);
        for (const interop::ProbeOutput& output : outputs) {
            // The target lies off the light by rounding: only where that is far smaller than the distance
            // does it tell the density by area.
            const glm::dvec3 point = glm::dvec3(output.target) + data.origin;
            if (glm::distance(point, position) < 0.2) continue;
            const double pdf =
                0.5 / angle +
                0.5 * density_by_area(point_at(kLight, coordinates_of(kLight, point)), position);
            ASSERT_NEAR(static_cast<double>(output.pdf), pdf, kFacingError * pdf);
        }
    }
}

// Too thin for float32 to tell their solid angle. What samples of a cell bring is its solid angle in the
// mean: that needs places and density to agree. Samples over the area, of which few are near, vary a hundred
// times as much.
TEST_F(TriangleLight, PointsOnANearThinOneAreDenseWhereItIsNear) {
    // Of what a sample brings, over the squared mean: (pi^2 / 8) by the cosine at which a long strip is met,
    // 4 / 3 by a triangle's width. Where half of the samples are of another kind, at most twice as much.
    constexpr double kMostSquare = 4.0 / 3.0 * 1.2338;
    constexpr double kLeastShare = 1.0 / 500;  // of the solid angle, of a cell that is told from others
    for (const bool textured : {false, true}) {
        const SceneData data = light_scene(kThinLight, textured);
        std::uint32_t seed = 230;
        for (const glm::dvec3& from : {glm::dvec3(0.1, 0.003, 1.983), glm::dvec3(-0.5, 0.02, 1.995),
                                       glm::dvec3(1.01, 0, 1.99), glm::dvec3(0.3, 0.3, 1.7)}) {
            SCOPED_TRACE(testing::Message() << from.x << ' ' << from.y << ' ' << from.z);
            const double angle = solid_angle(kThinLight, from);
            const std::vector<double> angles = cell_angles(kThinLight, from);
            const auto told = [&](std::size_t cell) {
                return angles[cell] < kLeastShare * angle ? kCells : cell;
            };
            std::vector<double> expected(kCells + 1, 0.0);
            std::vector<double> sums(kCells + 1, 0.0);
            std::vector<double> squares(kCells + 1, 0.0);
            for (std::size_t cell = 0; cell < kCells; ++cell)
                expected[told(cell)] += angles[cell];
            for (const interop::ProbeOutput& output : samples_from(device(), data, from, seed++)) {
                const glm::dvec3 point = glm::dvec3(output.target) + data.origin;
                const std::size_t cell = told(cell_of(coordinates_of(kThinLight, point)));
                const double brings = 1.0 / static_cast<double>(output.pdf);
                sums[cell] += brings;
                squares[cell] += brings * brings;
            }
            for (std::size_t cell = 0; cell <= kCells; ++cell) {
                const double error = 4.5 * std::sqrt(squares[cell]) / kSamples;
                EXPECT_NEAR(sums[cell] / kSamples, expected[cell], error) << "cell " << cell;
            }
            const double square = std::accumulate(squares.begin(), squares.end(), 0.0) / kSamples;
            EXPECT_LE(square / (angle * angle), kMostSquare * (textured ? 2.0 : 1.0));
        }
    }
}

}  // namespace
}  // namespace utsuri::test
