// SPDX-License-Identifier: Apache-2.0
#include "support/estimate.h"

#include "renderers/film/frame_camera.h"

#include "kernels/trace_direct.h"

#include <gtest/gtest.h>

#include <cmath>

namespace utsuri::test {

Estimate estimate_of(const Image& image) {
    const auto count = static_cast<double>(image.pixels.size());
    Estimate estimate;
    for (const glm::vec3& pixel : image.pixels)
        estimate.mean += glm::dvec3(pixel) / count;
    glm::dvec3 squares(0.0);
    for (const glm::vec3& pixel : image.pixels) {
        const glm::dvec3 difference = glm::dvec3(pixel) - estimate.mean;
        squares += difference * difference;
    }
    estimate.standard_error = glm::sqrt(squares / (count * (count - 1.0)));
    return estimate;
}

void expect_radiance(const Estimate& estimate, const glm::dvec3& expected, double power) {
    for (int channel = 0; channel < 3; ++channel) {
        const double size = std::abs(expected[channel]);
        EXPECT_LE(estimate.standard_error[channel], power * size) << "too noisy to tell, channel " << channel;
        EXPECT_NEAR(estimate.mean[channel], expected[channel],
                    kSigmas * estimate.standard_error[channel] + kRounding * size)
            << "standard error " << estimate.standard_error[channel] << ", channel " << channel;
    }
}

void expect_radiance(const Estimate& estimate, double expected, double power) {
    expect_radiance(estimate, glm::dvec3(expected), power);
}

Observer::Observer(Device& device, const Scene& scene)
    : device_(device),
      data_(prepare_scene_data(scene)),
      gpu_scene_(device, data_),
      kernel_(device, "trace_direct", kernels::trace_direct, gpu_scene_.specialization(),
              gpu_scene_.bindings()) {}

Image Observer::picture(const Camera& camera, const RenderSettings& settings, std::uint32_t samples) {
    Film film(device_, settings.width, settings.height, "observed film");
    Progress progress;
    const FrameSettings frame{make_camera_info(camera, data_.origin, settings.width, settings.height),
                              settings.seed, settings.max_depth, interop::NONE};
    counts_ = kernel_.add_samples(film, frame, samples, progress);
    EXPECT_EQ(counts_.nonfinite, 0u);
    return film.resolve();
}

Image Observer::close_up(glm::dvec3 eye, glm::dvec3 target, std::uint32_t samples, std::uint32_t seed) {
    RenderSettings settings;
    settings.width = kCloseUpSize;
    settings.height = kCloseUpSize;
    settings.seed = seed;
    return picture(look_at(eye, target, kCloseUpAngle), settings, samples);
}

Estimate Observer::look(glm::dvec3 eye, glm::dvec3 target, std::uint32_t samples, std::uint32_t seed) {
    return estimate_of(close_up(eye, target, samples, seed));
}

}  // namespace utsuri::test
