// SPDX-License-Identifier: Apache-2.0
// Irradiance from triangles that horizons cut, against clipping and summing in double precision.
#include "kernels/irradiance_probe.h"

#include "support/light_scenes.h"
#include "support/test_device.h"

#include "geometry/clip_polygon.h"
#include "gpu/probe.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace utsuri {
namespace {

using interop::IrradianceQuery;

/// Five parts of up to pi, each off by 4e-7 of it (angle_of()) and some roundings, and halved.
constexpr double kParts = 5.0 * 3.14159265 * (4e-7 + 8.0 * 0x1p-24) / 2.0;

class IrradianceProbe : public DeviceTest {
  protected:
    static std::vector<float> ask(const std::vector<IrradianceQuery>& queries) {
        return test::ask<float>(device(), "irradiance_probe", kernels::irradiance_probe, queries);
    }
};

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

double expected_irradiance(const IrradianceQuery& query) {
    std::vector<glm::dvec3> polygon = {query.q0, query.q1, query.q2};
    polygon = clip_polygon(polygon, glm::dvec3(query.ng), 0.0);
    if (polygon.size() >= 3 && query.ns != query.ng)
        polygon = clip_polygon(polygon, glm::dvec3(query.ns), 0.0);
    return polygon.size() < 3
               ? 0.0
               : std::abs(test::polygon_irradiance(polygon, glm::dvec3(0.0), glm::dvec3(query.ns)));
}

// Triangles of all sizes and distances about a surface whose interpolated normal differs from its own by up
// to some 60 degrees; none passes through the surface's point itself.
TEST_F(IrradianceProbe, IsThatOfWhatIsAboveBothHorizons) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<IrradianceQuery> queries;
    while (queries.size() < 20000) {
        const glm::dvec3 ng = random_direction(random);
        const bool is_flat = queries.size() % 4 == 0;
        const glm::dvec3 ns = is_flat ? ng : glm::normalize(ng + 0.9 * random_direction(random));
        const double size = std::pow(10.0, 4.0 * uniform(random) - 2.0);
        const glm::dvec3 middle = random_direction(random);
        const glm::dvec3 q0 = middle + size * random_direction(random);
        const glm::dvec3 q1 = middle + size * random_direction(random);
        const glm::dvec3 q2 = middle + size * random_direction(random);
        const glm::dvec3 plane = glm::cross(q1 - q0, q2 - q0);
        if (std::abs(glm::dot(glm::normalize(plane), q0)) < 0.05 * glm::length(q0)) continue;
        queries.push_back({glm::vec3(q0), glm::vec3(q1), glm::vec3(q2), glm::vec3(ng), glm::vec3(ns)});
    }
    const std::vector<float> answers = ask(queries);
    int dark = 0;
    int cut = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const double expected = expected_irradiance(queries[i]);
        EXPECT_NEAR(static_cast<double>(answers[i]), expected, kParts) << i;
        if (expected == 0.0) ++dark;
        const std::vector<glm::dvec3> whole = {queries[i].q0, queries[i].q1, queries[i].q2};
        const auto above = clip_polygon(whole, glm::dvec3(queries[i].ns), 0.0);
        if (above.size() >= 3 && above != whole) ++cut;
    }
    EXPECT_GT(dark, 2000);
    EXPECT_GT(cut, 2000);
}

TEST_F(IrradianceProbe, KnowsNoAbsoluteSize) {
    const IrradianceQuery query{
        {0.3f, 1.0f, -0.2f}, {-0.7f, -0.4f, 0.1f}, {0.2f, 0.8f, 0.9f}, {0, 1, 0}, {0.6f, 0.8f, 0}};
    std::vector<IrradianceQuery> queries;
    for (const int power : {0, -60, 60, -120, 120}) {
        IrradianceQuery scaled = query;
        for (glm::vec3* q : {&scaled.q0, &scaled.q1, &scaled.q2})
            *q = std::ldexp(1.0f, power) * *q;
        queries.push_back(scaled);
    }
    const std::vector<float> answers = ask(queries);
    EXPECT_GT(answers[0], 0.01f);
    for (const float answer : answers)
        EXPECT_EQ(answer, answers[0]);
}

}  // namespace
}  // namespace utsuri
