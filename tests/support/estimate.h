// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/film_kernel.h"
#include "renderers/methods/renderer.h"
#include "support/scenes.h"

#include "gpu/device.h"

#include <cstdint>
#include <memory>

namespace utsuri::test {

/// Largest accepted distance from an expected value, in standard errors: about 7e-6 false alarms a test.
inline constexpr double kSigmas = 4.5;
/// Largest standard error, relative to the expected value, at which a test still says something.
inline constexpr double kPower = 3e-4;
/// Relative error of fewer than about 30 float32 roundings without cancellation: 30 * 2^-24.
inline constexpr double kRounding = 2e-6;

/// Mean over the pixels of a picture that all have the same expected value, and its standard error from their
/// spread. Pixels are independent estimates because the sampler is keyed by pixel.
struct Estimate {
    glm::dvec3 mean{0.0};
    glm::dvec3 standard_error{0.0};
};
Estimate estimate_of(const Image& image);

/// Fails where a channel's mean is farther from the expected value than its standard error and float32
/// explain, or where the standard error is too large (more than `power` of the expected value) to tell.
void expect_radiance(const Estimate& estimate, const glm::dvec3& expected, double power = kPower);
void expect_radiance(const Estimate& estimate, double expected, double power = kPower);

/// A scene held on the device for many looks at it by direct/trace.
class Observer {
  public:
    Observer(Device& device, const Scene& scene);

    Image picture(const Camera& camera, const RenderSettings& settings, std::uint32_t samples);
    /// A picture of 16 x 16 pixels so narrow (1e-4 rad) that all show the same point.
    Image close_up(glm::dvec3 eye, glm::dvec3 target, std::uint32_t samples, std::uint32_t seed = 0);
    Estimate look(glm::dvec3 eye, glm::dvec3 target, std::uint32_t samples, std::uint32_t seed = 0);

    [[nodiscard]] const SceneData& data() const { return data_; }
    [[nodiscard]] const GpuScene& gpu_scene() const { return gpu_scene_; }
    /// Of the latest picture.
    [[nodiscard]] const FrameCounts& counts() const { return counts_; }

  private:
    Device& device_;
    SceneData data_;
    GpuScene gpu_scene_;
    FilmKernel kernel_;
    FrameCounts counts_;
};

/// Settings of close_up().
inline constexpr std::uint32_t kCloseUpSize = 16;
inline constexpr double kCloseUpAngle = 1e-4;

}  // namespace utsuri::test
