// SPDX-License-Identifier: Apache-2.0
#include "geometry/polyhedron.h"

#include "base/error.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

namespace utsuri {
namespace {

using testing::HasSubstr;

/// Corners are cut out of a square a million times as wide as its plane is far: ten digits are left of
/// sixteen, and acos halves what is left where it is steepest.
constexpr double kCorners = 1e-8;

/// Solid angle of a convex polygon seen from the origin: the angle sum of its spherical polygon.
double solid_angle(const std::vector<glm::dvec3>& corners) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& before = corners[(i + corners.size() - 1) % corners.size()];
        const glm::dvec3& after = corners[(i + 1) % corners.size()];
        const glm::dvec3 left = glm::normalize(glm::cross(corners[i], before));
        const glm::dvec3 right = glm::normalize(glm::cross(corners[i], after));
        sum += std::acos(glm::clamp(glm::dot(left, right), -1.0, 1.0));
    }
    return sum - static_cast<double>(corners.size() - 2) * std::numbers::pi;
}

struct Solid {
    const char* name;
    std::size_t faces;
    std::size_t corners;  ///< of a face
};

class PlatonicSolid : public testing::TestWithParam<Solid> {};

TEST_P(PlatonicSolid, HasItsFacesWhichCoverAllDirectionsOnce) {
    const Polyhedron solid = platonic_solid(GetParam().name);
    ASSERT_EQ(solid.planes.size(), GetParam().faces);
    double covered = 0.0;
    for (std::size_t i = 0; i < solid.planes.size(); ++i) {
        const auto corners = face_corners(solid, i);
        EXPECT_EQ(corners.size(), GetParam().corners);
        const double angle = solid_angle(corners);
        EXPECT_NEAR(angle, 4.0 * std::numbers::pi / static_cast<double>(GetParam().faces), kCorners);
        covered += angle;
    }
    EXPECT_NEAR(covered, 4.0 * std::numbers::pi, kCorners);
}

// A direction points at the face whose plane it meets first, inside that face's picture; there the picture's
// point lies along it.
TEST_P(PlatonicSolid, PicturesHoldWhatPointsAtTheirFace) {
    const Polyhedron solid = platonic_solid(GetParam().name);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 1000; ++n) {
        const glm::dvec3 direction(normal(random), normal(random), normal(random));
        std::size_t face = 0;
        for (std::size_t i = 1; i < solid.planes.size(); ++i) {
            if (glm::dot(solid.planes[i].normal, direction) / solid.planes[i].distance >
                glm::dot(solid.planes[face].normal, direction) / solid.planes[face].distance)
                face = i;
        }
        const interop::MapFace map = map_face(solid, face);
        const glm::dvec3 q(glm::dot(glm::dvec3(map.right), direction),
                           glm::dot(glm::dvec3(map.up), direction),
                           glm::dot(glm::dvec3(map.outward), direction));
        ASSERT_GT(q.z, 0.0);
        const glm::dvec2 p = glm::dvec2(q) / q.z;
        // MapFace is float32.
        EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1.0 + 1e-6);
        const FacePicture picture = face_picture(solid, face);
        const glm::dvec3 point = picture.centre + p.x * picture.right + p.y * picture.up;
        EXPECT_LE(glm::length(glm::cross(glm::normalize(point), glm::normalize(direction))), 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(All, PlatonicSolid,
                         testing::Values(Solid{"tetrahedron", 4, 3}, Solid{"cube", 6, 4},
                                         Solid{"octahedron", 8, 3}, Solid{"dodecahedron", 12, 5},
                                         Solid{"icosahedron", 20, 3}),
                         [](const auto& solid) { return std::string(solid.param.name); });

TEST(PlatonicSolids, AreListedWhereANameIsUnknown) {
    try {
        platonic_solid("cuboid");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("dodecahedron"));
    }
}

class PolyhedronFile : public testing::Test {
  protected:
    void SetUp() override { path_ = std::filesystem::temp_directory_path() / "utsuri_polyhedron_test.txt"; }
    void TearDown() override { std::filesystem::remove(path_); }

    Polyhedron read(const std::string& text) {
        std::ofstream(path_) << text;
        return read_polyhedron(path_);
    }

    void expect_error(const std::string& text, const std::string& part) {
        try {
            read(text);
            ADD_FAILURE() << "read: " << text;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(part));
        }
    }

    std::filesystem::path path_;
};

TEST_F(PolyhedronFile, HoldsAPlaneALine) {
    const Polyhedron wedge =
        read("# a wedge\n2 0 0 1\n-1 0 0 1  # left\n\n0 1 0 0.5\n0 -1 0 0.5\n0 0 -1 3\n1 0 1 4\n");
    ASSERT_EQ(wedge.planes.size(), 6u);
    EXPECT_EQ(wedge.planes[0].normal, glm::dvec3(1, 0, 0));
    EXPECT_EQ(wedge.planes[2].distance, 0.5);
    double covered = 0.0;
    for (std::size_t i = 0; i < 6; ++i)
        covered += solid_angle(face_corners(wedge, i));
    EXPECT_NEAR(covered, 4.0 * std::numbers::pi, kCorners);
}

TEST_F(PolyhedronFile, MustBeNumbers) {
    expect_error("1 0 0 1\n1 0 zero 1\n", "line 2");
    expect_error("1 0 0\n", "four numbers");
    expect_error("1 0 0 1 5\n", "four numbers");
    expect_error("0 0 0 1\n", "not zero");
    expect_error("1 0 0 1\n-1 0 0 1\n0 1 0 1\n1 0 0 -1\n", "line 4");
    expect_error("1 0 0 1\n-1 0 0 1\n0 1 0 1\n1 0 0 -1\n", "positive");
    expect_error("1 0 0 nan\n", "line 1");
    expect_error("", "0 planes");
}

TEST_F(PolyhedronFile, MustEncloseTheCapturePoint) {
    // Without a top.
    expect_error("1 0 0 1\n-1 0 0 1\n0 0 1 1\n0 0 -1 1\n0 -1 0 1\n", "enclose");
    // A plane beyond the others.
    expect_error("1 0 0 1\n-1 0 0 1\n0 0 1 1\n0 0 -1 1\n0 -1 0 1\n0 1 0 1\n1 0 0 2\n", "plane 7");
    // A plane twice.
    expect_error("1 0 0 1\n-1 0 0 1\n0 0 1 1\n0 0 -1 1\n0 -1 0 1\n0 1 0 1\n1 0 0 1\n", "plane 7");
}

TEST_F(PolyhedronFile, MayBeNearlyDegenerate) {
    // A slab 1e-3 thick.
    const Polyhedron slab = read("1 0 0 1\n-1 0 0 1\n0 0 1 1\n0 0 -1 1\n0 -1 0 5e-4\n0 1 0 5e-4\n");
    double covered = 0.0;
    for (std::size_t i = 0; i < 6; ++i)
        covered += solid_angle(face_corners(slab, i));
    EXPECT_NEAR(covered, 4.0 * std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace utsuri
