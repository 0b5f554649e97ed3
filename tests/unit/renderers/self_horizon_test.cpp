// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/self_horizon.h"

#include "support/scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace utsuri {
namespace {

/// What facets in one plane rise by before each other: corners are off by 2^-24 of coordinates up to 4, the
/// least edges here are some 0.05.
constexpr double kFlat = 1e-5;

/// What the bound adds for the rounding of sines in float32, and some.
constexpr double kRoom = 2e-5;

std::vector<Corners> surface_of(const Mesh& mesh) {
    std::vector<Corners> surface;
    for (const glm::uvec3& t : mesh.triangles)
        surface.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    return surface;
}

/// A grid over the unit square, its front where u x v of place(u, v) points.
std::vector<Corners> sheet(int cells, const std::function<glm::dvec3(double, double)>& place) {
    std::vector<Corners> surface;
    const auto at = [&](int i, int j) {
        return glm::dvec3(glm::vec3(place(static_cast<double>(i) / cells, static_cast<double>(j) / cells)));
    };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            surface.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            surface.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return surface;
}

std::vector<Corners> dish() {
    return sheet(12, [](double u, double v) {
        const glm::dvec2 c(2.0 * u - 1.0, 2.0 * v - 1.0);
        return glm::dvec3(c, 0.25 * glm::dot(c, c));
    });
}

std::vector<Corners> torus(int cells) {
    return sheet(cells, [](double u, double v) {
        const double a = 2.0 * std::numbers::pi * u;
        const double b = 2.0 * std::numbers::pi * v;
        const double r = 1.0 + 0.4 * std::cos(b);
        return glm::dvec3(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
    });
}

std::vector<Corners> shards() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    std::vector<Corners> surface;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 at = 3.0 * vector();
        surface.push_back({at + 0.3 * vector(), at + 0.3 * vector(), at + 0.3 * vector()});
    }
    return surface;
}

/// Needles about a common corner, turned any way and folded over each other.
std::vector<Corners> fans() {
    std::mt19937 random(9);
    std::normal_distribution<double> number;
    const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    std::vector<Corners> surface;
    for (int fan = 0; fan < 20; ++fan) {
        const glm::dvec3 apex = 40.0 * vector();
        for (int i = 0; i < 6; ++i) {
            const glm::dvec3 tip = apex + 2.0 * vector();
            surface.push_back({apex, tip, tip + (i % 2 == 0 ? 0.02 : 1.0) * vector()});
        }
    }
    return surface;
}

/// On a corner, on an edge, or anywhere: elevations are greatest where triangles end.
glm::dvec3 random_point(const Corners& corners, std::mt19937& random) {
    std::uniform_real_distribution<double> number(0.0, 1.0);
    const std::uint32_t kind = random() % 3;
    const std::size_t corner = random() % 3;
    if (kind == 0) return corners[corner];
    if (kind == 1) return glm::mix(corners[corner], corners[(corner + 1) % 3], number(random));
    const double root = std::sqrt(number(random));
    const double share = number(random);
    return (1.0 - root) * corners[0] + root * (1.0 - share) * corners[1] + root * share * corners[2];
}

/// The greatest sine at which points of a surface are seen from points of each of its triangles.
std::vector<double> seen_elevations(const std::vector<Corners>& surface, int pairs) {
    std::mt19937 random(11);
    std::vector<double> elevations;
    for (const Corners& ground : surface) {
        const glm::dvec3 normal = glm::normalize(doubled_area(ground));
        double highest = 0.0;
        for (const Corners& other : surface) {
            if (&other == &ground) continue;
            for (int i = 0; i < pairs; ++i) {
                const glm::dvec3 way = random_point(other, random) - random_point(ground, random);
                if (way == glm::dvec3(0.0)) continue;
                highest = std::max(highest, glm::dot(normal, way) / glm::length(way));
            }
        }
        elevations.push_back(highest);
    }
    return elevations;
}

TEST(SelfHorizon, OfConvexSurfacesIsFlat) {
    for (const float at : {0.0f, 100.0f}) {
        for (const float horizon : self_horizons(surface_of(test::icosphere({at, 1.0f, 0.0f}, 0.3f, 4))))
            EXPECT_LE(horizon, at == 0.0f ? 0.0f : 2e-3f);  // 2^-24 of 100 over edges of 0.02
    }
    for (const float horizon : self_horizons(surface_of(test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}))))
        EXPECT_EQ(horizon, 0.0f);
}

// Walls that meet at right angles, fronts inside.
TEST(SelfHorizon, OfARoomSeenFromInsideIsUpright) {
    for (const float horizon : self_horizons(surface_of(test::room({-1, 0.5f, -1}, {1, 2, 1}))))
        EXPECT_EQ(horizon, 1.0f);
}

TEST(SelfHorizon, AcrossAnEdgeIsTheTiltOfItsNeighbour) {
    for (const double degrees : {1.0, 30.0, 60.0, 89.0, 120.0, 175.0, -30.0}) {
        const double tilt = degrees / 180.0 * std::numbers::pi;
        // The neighbour's far corner lies beside the edge, seen along it.
        const std::vector<Corners> surface = {
            Corners{glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0)},
            Corners{glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 0),
                    glm::dvec3(std::cos(tilt), 2.0, std::sin(tilt))}};
        const double expected = degrees < 0.0 ? 0.0 : (degrees > 90.0 ? 1.0 : std::sin(tilt));
        for (const float horizon : self_horizons(surface))
            EXPECT_NEAR(static_cast<double>(horizon), expected, kRoom) << degrees << " degrees";
    }
}

// A ball of a hundredth at a distance of 1 and a height of 1: 45 degrees, give or take its size.
TEST(SelfHorizon, OfSomethingFarIsItsElevation) {
    std::vector<Corners> surface = {
        Corners{glm::dvec3(0, 0, 0), glm::dvec3(0.01, 0, 0), glm::dvec3(0, 0.01, 0)}};
    for (const Corners& corners : surface_of(test::icosphere({1.0f, 0.0f, 1.0f}, 0.01f, 3)))
        surface.push_back(corners);
    EXPECT_NEAR(static_cast<double>(self_horizons(surface).front()), std::sqrt(0.5), 0.03);
}

TEST(SelfHorizon, IsNeverBelowWhatIsSeen) {
    for (const auto& [name, surface] : {std::pair("dish", dish()), std::pair("torus", torus(16)),
                                        std::pair("shards", shards()), std::pair("fans", fans())}) {
        const std::vector<float> horizons = self_horizons(surface);
        const std::vector<double> seen = seen_elevations(surface, 60);
        std::vector<double> shares;
        for (std::size_t i = 0; i < surface.size(); ++i) {
            EXPECT_GE(static_cast<double>(horizons[i]) + kFlat, seen[i]) << name << ' ' << i;
            if (seen[i] > kFlat) shares.push_back(seen[i] / static_cast<double>(horizons[i]));
        }
        // What the bound is for: that it is seldom far above.
        ASSERT_FALSE(shares.empty());
        std::sort(shares.begin(), shares.end());
        EXPECT_GT(shares[shares.size() / 2], 0.8) << name;
    }
}

// The outer half of a ring is as free as a ball; rays from its inner half may cross the hole.
TEST(SelfHorizon, OfARingRisesOnItsInnerHalfAlone) {
    const std::vector<Corners> surface = torus(24);
    const std::vector<float> horizons = self_horizons(surface);
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const glm::dvec3 centre = (surface[i][0] + surface[i][1] + surface[i][2]) / 3.0;
        const double r = std::hypot(centre.x, centre.y);
        if (r > 1.1) {
            EXPECT_LT(horizons[i], 0.06f) << "at " << r;  // facets are bent along the hole
        }
        if (r < 0.7) {
            EXPECT_GT(horizons[i], 0.5f) << "at " << r;
        }
    }
}

// The other's far edge comes within a hundredth of an edge of upright at its very end.
TEST(SelfHorizon, AroundACornerIsThatOfTheEndOfANeedle) {
    const std::vector<Corners> surface = {
        Corners{glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0)},
        Corners{glm::dvec3(0, 0, 0), glm::dvec3(0.01, 0, 0.01), glm::dvec3(1, 0.5, 0)}};
    const auto horizon = static_cast<double>(self_horizons(surface).front());
    EXPECT_GE(horizon, std::sqrt(0.5));
    EXPECT_LE(horizon, 1.02 * std::sqrt(0.5));
}

// Corrugations of half a millimetre, a kilometre from the origin: just more than rounding can be.
TEST(SelfHorizon, OfSmallThingsFarFromTheOriginIsNotFlat) {
    const std::vector<Corners> surface = sheet(8, [](double u, double v) {
        const int step = static_cast<int>(std::lround(8.0 * u));
        return glm::dvec3(1000.0 + 0.25 * u, 0.25 * v, step % 2 == 0 ? 0.0 : 0x1p-11);
    });
    const std::vector<float> horizons = self_horizons(surface);
    for (std::size_t i = 0; i < surface.size(); ++i) {
        // Those at the ends have no valley before them.
        if (surface[i][0].x < 1000.03 || surface[i][0].x > 1000.21) continue;
        EXPECT_GT(horizons[i], 0.01f) << i;
    }
}

TEST(SelfHorizon, IsTheSameAtAnyScale) {
    for (const int k : {-40, 40}) {
        std::vector<Corners> scaled = dish();
        for (Corners& corners : scaled) {
            for (glm::dvec3& corner : corners)
                corner *= std::ldexp(1.0, k);
        }
        EXPECT_EQ(self_horizons(scaled), self_horizons(dish())) << "2^" << k;
    }
}

TEST(SelfHorizon, OfNothingIsNothing) {
    EXPECT_TRUE(self_horizons({}).empty());
    const Corners point = {glm::dvec3(1, 2, 3), glm::dvec3(1, 2, 3), glm::dvec3(1, 2, 3)};
    EXPECT_EQ(self_horizons({point, point}), (std::vector<float>{0.0f, 0.0f}));
}

}  // namespace
}  // namespace utsuri
