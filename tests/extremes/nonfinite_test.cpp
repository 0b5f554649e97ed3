// SPDX-License-Identifier: Apache-2.0
// A sample that is no number is counted and left out. Tests that expect a count of zero rest on this.
#include "support/methods.h"
#include "support/test_device.h"

#include <gmock/gmock.h>

#include <limits>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{8, 4, 0, 2};
constexpr std::uint32_t kSamples = 3;

class Nonfinite : public DeviceTest {
  protected:
    static Scene surroundings(float radiance) {
        Scene scene;
        scene.environment = glm::vec3(1.0f, radiance, 1.0f);
        return scene;
    }

    static void expect_all_counted(const Traced& result) {
        EXPECT_EQ(result.statistics.counts.nonfinite, kSettings.width * kSettings.height * kSamples);
        EXPECT_THAT(result.image.pixels, testing::Each(glm::vec3(0.0f)));
    }

    Camera camera_ = look_at(glm::dvec3(0), glm::dvec3(0, 0, -1));
};

TEST_F(Nonfinite, SamplesAreCountedAndLeftOut) {
    const Scene scene = surroundings(std::numeric_limits<float>::infinity());
    expect_all_counted(trace(device(), scene, camera_, kSettings, kSamples));
    DrawnScene drawn(device(), scene);
    for (const DrawnMethod& method : drawn_methods())
        expect_all_counted(drawn.render(method, camera_, kSettings, MapSettings{4, 1, {}}, kSamples));
}

TEST_F(Nonfinite, LargeSamplesAreNot) {
    const Traced result = trace(device(), surroundings(1e37f), camera_, kSettings, kSamples);
    EXPECT_EQ(result.statistics.counts.nonfinite, 0u);
    EXPECT_THAT(result.image.pixels, testing::Each(glm::vec3(1.0f, 1e37f, 1.0f)));
}

}  // namespace
}  // namespace utsuri::test
