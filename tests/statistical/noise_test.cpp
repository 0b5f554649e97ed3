// SPDX-License-Identifier: Apache-2.0
// What a film tells about its own noise, and that nothing connects one pixel, seed or half with another.
#include "renderers/film/film_kernel.h"
#include "renderers/film/frame_camera.h"
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "kernels/trace_direct.h"

#include <cmath>

namespace utsuri::test {
namespace {

class Noise : public DeviceTest {};

/// Part shadow under a square light.
Scene penumbra() {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(1.0f)));
    add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(3.0f)));
    add(scene, quad({0, 0.5f, -1}, {1, 0, 0}, {0, 0, 2}), lambert(glm::vec3(0.0f)));
    return scene;
}

/// Mean and standard error of independent values.
struct Mean {
    double value = 0.0;
    double error = 0.0;
};

Mean mean_of(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    Mean mean;
    for (const double value : values)
        mean.value += value / count;
    for (const double value : values)
        mean.error += (value - mean.value) * (value - mean.value);
    mean.error = std::sqrt(mean.error / (count * (count - 1.0)));
    return mean;
}

// The mean of the halves is the picture, and a half differs from it by as much as the estimate says that the
// picture differs from the truth.
TEST_F(Noise, HalvesMakeUpThePicture) {
    constexpr std::uint32_t kSize = 16;
    constexpr std::uint32_t kSamples = 6;
    const Scene scene = penumbra();
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    FilmKernel kernel(device(), "trace_direct", kernels::trace_direct, gpu_scene.specialization(),
                      gpu_scene.bindings());
    FrameSettings frame;
    frame.camera =
        make_camera_info(look_at({-1.0, 0.3, 1.5}, {0, 0, 0}, kCloseUpAngle), data.origin, kSize, kSize);
    Film film(device(), kSize, kSize, "halved film");
    Progress progress;
    kernel.add_samples(film, frame, 1, progress);
    EXPECT_EQ(film.resolve_half(0).pixels, film.resolve().pixels);
    EXPECT_EQ(film.resolve_half(1).pixels, Image(kSize, kSize).pixels);
    kernel.add_samples(film, frame, kSamples - 1, progress);
    const Image whole = film.resolve();
    const Image even = film.resolve_half(0);
    const Image odd = film.resolve_half(1);
    double squares = 0.0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        const glm::dvec3 mean = 0.5 * (glm::dvec3(even.pixels[i]) + glm::dvec3(odd.pixels[i]));
        for (int c = 0; c < 3; ++c) {
            const auto value = static_cast<double>(whole.pixels[i][c]);
            EXPECT_NEAR(mean[c], value, 0x1p-23 * value);  // float32, rounded to nearest
            const double difference = static_cast<double>(even.pixels[i][c]) - value;
            squares += difference * difference;
        }
    }
    const double noise = film.estimate_noise().mse;
    EXPECT_GT(noise, 0.0);
    EXPECT_NEAR(squares / (3.0 * kSize * kSize), noise,
                1e-5 * noise);  // differences of float32 values near 1
}

// The halves of a film predict the variance of its pixels: over 32 seeds the mean prediction is the variance
// that the 32 pictures really have.
TEST_F(Noise, PredictedErrorIsTheActualSpread) {
    constexpr std::uint32_t kSeeds = 32;
    constexpr std::uint32_t kSize = 32;
    const Scene scene = penumbra();
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    FilmKernel kernel(device(), "trace_direct", kernels::trace_direct, gpu_scene.specialization(),
                      gpu_scene.bindings());
    const Camera camera = look_at({-1.0, 0.3, 1.5}, {0, 0, 0}, kCloseUpAngle);
    Film film(device(), kSize, kSize, "noisy film");
    Progress progress;
    for (const std::uint32_t samples : {2u, 16u}) {
        std::vector<double> predictions;
        std::vector<double> sum(kSize * kSize, 0.0);
        std::vector<double> squares(kSize * kSize, 0.0);
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
            film.clear();
            FrameSettings frame;
            frame.camera = make_camera_info(camera, data.origin, kSize, kSize);
            frame.seed = seed;
            kernel.add_samples(film, frame, samples, progress);
            predictions.push_back(film.estimate_noise().mse);
            const Image image = film.resolve();
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                const auto value = static_cast<double>(image.pixels[i].x);
                sum[i] += value;
                squares[i] += value * value;
            }
        }
        std::vector<double> variances;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            variances.push_back((squares[i] - sum[i] * sum[i] / kSeeds) / (kSeeds - 1.0));
        }
        const Mean predicted = mean_of(predictions);
        const Mean actual = mean_of(variances);
        const double deviation = std::hypot(predicted.error, actual.error);
        EXPECT_LE(deviation, 0.05 * actual.value) << "too noisy to tell";
        EXPECT_NEAR(predicted.value, actual.value, kSigmas * deviation) << samples << " samples";
    }
}

/// Correlation of two sets of values, in units of its standard error for independent ones, 1 / sqrt(n).
double correlation_score(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = mean_of(a).value;
    const double mean_b = mean_of(b).value;
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb) * std::sqrt(static_cast<double>(a.size()));
}

/// Score of each pixel against the one (dx, dy) further.
double neighbour_score(const Image& image, std::uint32_t dx, std::uint32_t dy) {
    std::vector<double> here;
    std::vector<double> there;
    for (std::uint32_t y = 0; y + dy < image.height; ++y) {
        for (std::uint32_t x = 0; x + dx < image.width; ++x) {
            here.push_back(static_cast<double>(image.at(x, y).x));
            there.push_back(static_cast<double>(image.at(x + dx, y + dy).x));
        }
    }
    return correlation_score(here, there);
}

TEST_F(Noise, PixelsAndSeedsAreIndependent) {
    Observer observer(device(), penumbra());
    RenderSettings settings;
    settings.width = settings.height = 96;
    const Camera camera = look_at({-1.0, 0.3, 1.5}, {0, 0, 0}, kCloseUpAngle);
    for (const std::uint32_t samples : {1u, 8u}) {
        settings.seed = 0;
        const Image image = observer.picture(camera, settings, samples);
        for (const auto& [dx, dy] : {std::pair(1u, 0u), std::pair(0u, 1u), std::pair(1u, 1u),
                                     std::pair(2u, 0u), std::pair(8u, 0u), std::pair(0u, 8u)}) {
            EXPECT_LE(std::abs(neighbour_score(image, dx, dy)), kSigmas)
                << dx << ' ' << dy << ", " << samples;
        }
        std::vector<double> straight;
        std::vector<double> transposed;
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < y; ++x) {
                straight.push_back(static_cast<double>(image.at(x, y).x));
                transposed.push_back(static_cast<double>(image.at(y, x).x));
            }
        }
        EXPECT_LE(std::abs(correlation_score(straight, transposed)), kSigmas) << "across the diagonal";
        std::vector<double> first;
        for (const glm::vec3& pixel : image.pixels)
            first.push_back(static_cast<double>(pixel.x));
        for (const std::uint32_t seed : {1u, 2u, 0x80000000u}) {
            settings.seed = seed;
            std::vector<double> second;
            for (const glm::vec3& pixel : observer.picture(camera, settings, samples).pixels) {
                second.push_back(static_cast<double>(pixel.x));
            }
            EXPECT_LE(std::abs(correlation_score(first, second)), kSigmas) << "seed " << seed;
        }
    }
}

// A picture of 1 sample a pixel of this scene really is noisy, or the scores above would say nothing.
TEST_F(Noise, TheTestSceneIsNoisy) {
    const Estimate estimate = Observer(device(), penumbra()).look({-1.0, 0.3, 1.5}, {0, 0, 0}, 1);
    EXPECT_GT(estimate.standard_error.x, 0.02 * estimate.mean.x);
}

}  // namespace
}  // namespace utsuri::test
