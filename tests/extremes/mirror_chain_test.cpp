// SPDX-License-Identifier: Apache-2.0
// Long specular chains: references.md A6.4 and A6.5.
#include "support/scenes.h"
#include "support/test_device.h"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace utsuri::test {
namespace {

class MirrorChain : public DeviceTest {
  protected:
    /// Mirror metal of a reflectance that no angle changes much at normal incidence.
    static Material dim_mirror(float reflectance) {
        Material material = mirror();
        material.base_colour = glm::vec3(reflectance);
        return material;
    }

    /// The eye stands between two mirrors 1 m apart and looks straight at the one that also emits 1 cd/m2.
    /// The chain never ends but at `depth`.
    Traced facing_mirrors(float reflectance, std::uint32_t depth) {
        Scene scene;
        add(scene, quad(glm::vec3(-0.5f, -5, 5), glm::vec3(0, 0, -10), glm::vec3(0, 10, 0)),
            dim_mirror(reflectance));
        Material glowing = dim_mirror(reflectance);
        glowing.emissive = glm::vec3(1.0f);
        glowing.double_sided = true;
        add(scene, quad(glm::vec3(0.5f, -5, -5), glm::vec3(0, 0, 10), glm::vec3(0, 10, 0)), glowing);
        const Camera camera = look_at(glm::dvec3(0), glm::dvec3(1, 0, 0), 1e-3);
        return trace(device(), scene, camera, {1, 1, 0, depth}, 1);
    }
};

TEST_F(MirrorChain, FacingMirrorsAddUpAGeometricSeries) {
    // Every second hit emits 1: hits 0, 2, 4 ... So L = sum over j of (rho^2)^j for 2 j <= depth (Schlick's
    // rise at 5e-4 rad is 1e-14).
    for (const float reflectance : {0.5f, 0.9f, 0.999f}) {
        for (const std::uint32_t depth : {0u, 1u, 2u, 10u, 1000u}) {
            const double square = static_cast<double>(reflectance) * static_cast<double>(reflectance);
            const double terms = depth / 2 + 1;
            const double expected = (1.0 - std::pow(square, terms)) / (1.0 - square);
            const Traced result = facing_mirrors(reflectance, depth);
            // 1e-4 after 1000 reflections is what references.md C1.21 asks; each takes a handful of
            // roundings.
            const double tolerance = std::max(2e-6, 1e-7 * depth);
            EXPECT_NEAR(static_cast<double>(result.image.pixels[0].x) / expected, 1.0, tolerance)
                << reflectance << " depth " << depth;
            EXPECT_EQ(result.statistics.counts.truncated, 1u);
            EXPECT_EQ(result.statistics.counts.traced, depth);
        }
    }
}

TEST_F(MirrorChain, WedgeOfOneDegreeReflects180Times) {
    // A6.5: in a wedge of angle pi / m a ray makes exactly m reflections: unfolded, it is a straight line
    // that comes in between 0 and 1 degree about the z axis, leaves 0.23 degrees beyond 180, and crosses
    // every whole degree between.
    const float angle = glm::radians(1.0f);
    Scene scene;
    const glm::vec3 z(0, 0, 2);
    add(scene, quad(glm::vec3(0, 0, -1), z, glm::vec3(100, 0, 0)), mirror());
    add(scene, quad(glm::vec3(0, 0, -1), z, 100.0f * glm::vec3(std::cos(angle), std::sin(angle), 0)),
        mirror());
    const Camera camera = look_at(glm::dvec3(50, 0.4, 0), glm::dvec3(0, 0.2, 0), 1e-4);
    const Traced result = trace(device(), scene, camera, {1, 1, 0, 100000}, 1);
    EXPECT_EQ(result.statistics.counts.traced, 180u);
    EXPECT_EQ(result.statistics.counts.truncated, 0u);
}

TEST_F(MirrorChain, DimThroughputEndsAsZeroNotAsNan) {
    // 0.5^300 is far below the smallest float.
    const Traced result = facing_mirrors(0.5f, 300);
    EXPECT_EQ(result.statistics.counts.nonfinite, 0u);
    EXPECT_NEAR(static_cast<double>(result.image.pixels[0].x), 4.0 / 3.0, 1e-5);
}

}  // namespace
}  // namespace utsuri::test
