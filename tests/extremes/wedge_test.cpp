// SPDX-License-Identifier: Apache-2.0
// references.md A6.5: in a wedge of angle pi / m, with m even, a ray leaves antiparallel to its entry after
// exactly m reflections, on the other side of the edge at the same distance.
#include "support/scenes.h"
#include "support/test_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr float kRadiance = 3.0f;
/// Distance of the ray from the plane halfway between the mirrors, metres.
constexpr double kOffset = 0.004;

class Wedge : public DeviceTest {
  protected:
    /// Two mirrors of 1 m from the z axis at half the angle above and below the x axis; the eye looks from x
    /// = 1.2 m along -x, and a strip behind it shines where the ray should come back to.
    static Traced render(int reflections, double half_width) {
        const double half_angle = 0.5 * std::numbers::pi / reflections;
        Scene scene;
        for (const double side : {1.0, -1.0}) {
            const glm::vec3 outwards(glm::dvec3(std::cos(half_angle), side * std::sin(half_angle), 0.0));
            add(scene, quad({0, 0, -1}, {0, 0, 2}, outwards), mirror());
        }
        const auto lower = static_cast<float>(-kOffset - half_width);
        const auto height = static_cast<float>(2.0 * half_width);
        add(scene, quad({1.3f, lower, -0.5f}, {0, 0, 1}, {0, height, 0}), emitter(glm::vec3(kRadiance)));
        scene.materials.back().double_sided = true;
        const Camera camera = look_at({1.2, kOffset, 0.0}, {0.0, kOffset, 0.0}, 1e-6);
        const RenderSettings settings{1, 1, 0, 10000};
        return trace(device(), scene, camera, settings, 1);
    }
};

TEST_F(Wedge, SendsTheRayBackAntiparallel) {
    // Each reflection errs by some 8 roundings in direction, the two normals by as much for all reflections:
    // for 180, 180 * 16 * 2^-24 = 1.7e-4 rad over a way of 2.6 m. Leaving a surface at half a metre moves by
    // 4e-7 m each time.
    const double bound = 2.6 * 180 * 16 * 0x1p-24 + 180 * 4e-7;
    ASSERT_LT(bound, 0.25 * kOffset) << "a strip this wide would tell nothing";
    const Traced result = render(180, bound);
    EXPECT_EQ(result.statistics.counts.traced, 180u);
    EXPECT_EQ(result.statistics.counts.truncated, 0u);
    EXPECT_EQ(result.image.pixels[0], glm::vec3(kRadiance)) << "the strip is missed";
}

TEST_F(Wedge, ReflectsAsOftenAsItsAngleSays) {
    for (const int reflections : {2, 4, 6, 18, 60}) {
        EXPECT_EQ(render(reflections, 1e-3).image.pixels[0], glm::vec3(kRadiance)) << reflections;
        EXPECT_EQ(render(reflections, 1e-3).statistics.counts.traced,
                  static_cast<std::uint64_t>(reflections));
    }
}

}  // namespace
}  // namespace utsuri::test
