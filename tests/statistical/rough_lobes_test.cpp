// SPDX-License-Identifier: Apache-2.0
// `hybrid` shows what glossy lobes reflect as direct/trace does: on walls and floors of glTF's default
// dielectrics, where things touch, beside a metal, near a lamp.
#include "renderers/methods/method.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <gtest/gtest.h>

#include <cmath>

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{128, 96, 5, 8};
constexpr std::uint32_t kDrawnSamples = 16;
constexpr std::uint32_t kTracedSamples = 256;
constexpr std::uint32_t kBlock = 32;

/// What is promised of a picture of 16 samples, as shares of the mean of the whole picture.
constexpr double kMostOfBlock = 0.03;
constexpr double kMostOfPicture = 0.01;
/// Standard deviations of the noise that are given in beside: of 13 means one in ten thousand runs has a
/// larger one.
constexpr double kDeviations = 4.5;

Material dielectric(const glm::vec3& colour, float roughness) {
    Material material;
    material.base_colour = colour;
    material.metallic = 0.0f;
    material.roughness = roughness;
    return material;
}

/// A room of default dielectrics with a wall 8 m long, a ball that touches the floor, a rough metal block and
/// a lamp near the ceiling.
Scene dielectric_room() {
    Scene scene;
    add(scene, room({-4, 0, -2}, {4, 3, 2}), dielectric({0.7f, 0.65f, 0.6f}, 0.5f));
    add(scene, quad({-4, 0.001f, -2}, {0, 0, 4}, {8, 0, 0}), dielectric({0.35f, 0.25f, 0.2f}, 0.25f));
    add(scene, icosphere({0.3f, 0.451f, 0}, 0.45f, 3), dielectric({0.2f, 0.3f, 0.7f}, 0.3f));
    add(scene, block({-1.5f, 0.001f, -0.8f}, {-0.8f, 0.9f, 0}),
        glossy_metal(0.3f, glm::vec3(0.8f, 0.6f, 0.4f)));
    add(scene, block({1.4f, 0.001f, -0.5f}, {1.45f, 1.6f, 1.2f}), dielectric({0.6f, 0.6f, 0.2f}, 0.4f));
    add(scene, ceiling({0, 2.95f, 0}, 0.6f), emitter(glm::vec3(30)));
    return scene;
}

/// The mean of a part of a picture, all channels together, and the variance of that by its noise, as the
/// difference of both halves of its samples tells.
struct Mean {
    double value = 0.0;
    double variance = 0.0;
};

Mean mean_of(const Film& film, std::uint32_t x0, std::uint32_t y0, std::uint32_t width,
             std::uint32_t height) {
    const Image whole = film.resolve();
    const Image first = film.resolve_half(0);
    const Image second = film.resolve_half(1);
    const auto sum = [](const glm::vec3& pixel) {
        return (static_cast<double>(pixel.x) + static_cast<double>(pixel.y) + static_cast<double>(pixel.z)) /
               3.0;
    };
    Mean mean;
    for (std::uint32_t y = y0; y < y0 + height; ++y) {
        for (std::uint32_t x = x0; x < x0 + width; ++x) {
            mean.value += sum(whole.at(x, y));
            const double apart = 0.5 * (sum(first.at(x, y)) - sum(second.at(x, y)));
            mean.variance += apart * apart;
        }
    }
    const double pixels = static_cast<double>(width) * height;
    return {mean.value / pixels, mean.variance / (pixels * pixels)};
}

class RoughLobes : public DeviceTest {
  protected:
    static void render(const Scene& scene, const char* reflection, std::uint32_t samples, Film& film) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        LightSettings settings;
        settings.samples = 16;
        KeptLight light = kept_light(device(), data, gpu_scene, settings);
        const Method method = find_method("direct", reflection);
        const Camera camera = look_at({3.4, 1.6, 1.7}, {-0.3, 0.7, -0.2}, 1.0);
        const std::unique_ptr<Renderer> renderer =
            make_renderer(method, {device(), data, gpu_scene, *method.light, light, camera}, kPicture, {});
        Progress silent;
        renderer->prepare(silent);
        renderer->add_samples(film, samples, silent);
    }
};

TEST_F(RoughLobes, OfARoomOfDielectricsAreAsTraced) {
    Film drawn(device(), kPicture.width, kPicture.height, "drawn film");
    Film traced(device(), kPicture.width, kPicture.height, "traced film");
    render(dielectric_room(), "hybrid", kDrawnSamples, drawn);
    render(dielectric_room(), "trace", kTracedSamples, traced);
    const Mean whole = mean_of(traced, 0, 0, kPicture.width, kPicture.height);
    const auto expect_within = [&](double share, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                                   std::uint32_t height) {
        const Mean shown = mean_of(drawn, x, y, width, height);
        const Mean right = mean_of(traced, x, y, width, height);
        const double noise = std::sqrt(shown.variance + right.variance);
        EXPECT_NEAR(shown.value, right.value, share * whole.value + kDeviations * noise)
            << x << ' ' << y << ", with a noise of " << noise / whole.value << " of the mean";
        EXPECT_LT(noise, share * whole.value) << "too much to tell";
    };
    expect_within(kMostOfPicture, 0, 0, kPicture.width, kPicture.height);
    for (std::uint32_t y = 0; y < kPicture.height; y += kBlock) {
        for (std::uint32_t x = 0; x < kPicture.width; x += kBlock)
            expect_within(kMostOfBlock, x, y, kBlock, kBlock);
    }
}

}  // namespace
}  // namespace utsuri::test
