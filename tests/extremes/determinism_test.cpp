// SPDX-License-Identifier: Apache-2.0
// The same picture for any split of the work.
#include "renderers/methods/ray_tracer.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <gmock/gmock.h>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{40, 30, 3, 8};

class Determinism : public DeviceTest {
  protected:
    /// Renders 12 samples in the given portions.
    Image render(const std::vector<std::uint32_t>& portions, std::uint32_t seed = kSettings.seed) {
        const SceneData data = prepare_scene_data(everything_scene());
        const GpuScene scene(device(), data);
        RenderSettings settings = kSettings;
        settings.seed = seed;
        const std::unique_ptr<RayTracer> tracer =
            make_tracer(device(), data, scene, everything_camera(), settings);
        Film film(device(), settings.width, settings.height, "film");
        Progress progress;
        for (const std::uint32_t count : portions)
            tracer->add_samples(film, count, progress);
        EXPECT_EQ(film.samples(), 12u);
        return film.resolve();
    }
};

TEST_F(Determinism, SameRunTwice) {
    EXPECT_TRUE(render({12}).pixels == render({12}).pixels);
}

TEST_F(Determinism, AnySplitOfTheSamples) {
    const Image whole = render({12});
    EXPECT_TRUE(render({1, 11}).pixels == whole.pixels);
    EXPECT_TRUE(render({5, 4, 3}).pixels == whole.pixels);
    EXPECT_TRUE(render({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}).pixels == whole.pixels);
}

TEST_F(Determinism, SeedsDiffer) {
    EXPECT_FALSE(render({12}, 1).pixels == render({12}, 2).pixels);
}

TEST_F(Determinism, SumsKeepTheirDigitsOverManySamples) {
    // A uniform picture has the same value in every sample, so its mean must be that value to the bit,
    // however many samples there are; a plain float32 sum of 0.1 is off after a few thousand.
    Scene scene;
    scene.cameras.push_back(look_at(glm::dvec3(0), glm::dvec3(0, 0, -1)));
    scene.environment = glm::vec3(0.1f);
    const Image image = trace(device(), scene, scene.cameras.front(), {8, 8, 0, 1}, 20000).image;
    for (const glm::vec3& pixel : image.pixels)
        ASSERT_EQ(pixel, glm::vec3(0.1f));
}

TEST_F(Determinism, BandsOfATallPictureFitTogether) {
    // 3.2 million pixels of 48 bytes take three buffers of 64 MiB; the surroundings must be in each row.
    Scene scene;
    scene.environment = glm::vec3(2.0f);
    const Camera camera = look_at(glm::dvec3(0), glm::dvec3(0, 0, -1));
    const Image image = trace(device(), scene, camera, {8, 400000, 0, 1}, 1).image;
    EXPECT_THAT(image.pixels, testing::Each(glm::vec3(2.0f)));
}

}  // namespace
}  // namespace utsuri::test
