// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/scene_data.h"
#include "renderers/light/light_settings.h"
#include "renderers/light/surface_light.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace utsuri {

/// A point on the light axis: what light is simulated at diffuse surfaces, and how. One object each, listed
/// in methods/lights.cpp.
struct LightMethod {
    std::string_view name;     ///< as on the command line: "direct"
    std::string_view summary;  ///< for help texts, in a few words
    /// Keeps the light on surfaces, for what looks it up. Scene and device must outlive it.
    /// @throws DeviceError if it does not fit
    std::unique_ptr<SurfaceLight> (*keep)(Device& device, const SceneData& data, const GpuScene& scene,
                                          const LightSettings& settings);
    /// A film kernel (kernels/film/film_main.glsl) that follows rays and simulates the light anew at every
    /// surface that they meet.
    std::string_view kernel_name;
    std::span<const std::uint32_t> kernel;
};

/// The light of a method kept on the surfaces of a scene, made when it is first asked for: traced pictures
/// need none. Who reads it holds on to it.
class KeptLight {
  public:
    /// All of them must outlive this.
    KeptLight(Device& device, const SceneData& data, const GpuScene& scene, const LightMethod& method,
              const LightSettings& settings)
        : device_(device), data_(data), scene_(scene), method_(method), settings_(settings) {}

    /// @throws DeviceError if it does not fit
    [[nodiscard]] std::shared_ptr<SurfaceLight> get() {
        if (!light_) light_ = method_.keep(device_, data_, scene_, settings_);
        return light_;
    }
    /// Whether someone holds on to what get() returned.
    [[nodiscard]] bool is_in_use() const { return light_.use_count() > 1; }
    /// Tells it of a change of the scene, if it is there: SurfaceLight::update().
    void update(const SceneChange& change, Progress& progress) {
        if (light_) light_->update(change, progress);
    }

  private:
    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    const LightMethod& method_;
    LightSettings settings_;
    std::shared_ptr<SurfaceLight> light_;
};

}  // namespace utsuri
