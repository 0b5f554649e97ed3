// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/film_kernel.h"
#include "renderers/light/surface_light.h"

#include "gpu/kernel.h"

#include <cstdint>

namespace utsuri {

/// Traces what surrounds a point into texels of maps, without the instance that these are for, and with the
/// light kept on surfaces.
class TexelTracer {
  public:
    /// @param light filled before trace()
    /// @param projection of the maps: interop::PROJECTION_PERSPECTIVE or PROJECTION_SPHERE_MAP
    TexelTracer(Device& device, const GpuScene& scene, const SurfaceLight& light, std::uint32_t projection);
    TexelTracer(const TexelTracer&) = delete;
    TexelTracer& operator=(const TexelTracer&) = delete;

    /// Makes the driver compile what the rest needs. Film and texels stay as they are.
    void warm_up(Film& film, const Buffer& texels);

    /// One map.
    /// @param film of its size; samples that it has are forgotten
    /// @param samples of each texel, >= 1
    /// @param texels a vec3 each; the map's go there row by row from `first_texel` on
    /// @throws DeviceError
    FrameCounts trace(Film& film, const FrameSettings& frame, std::uint32_t samples, const Buffer& texels,
                      std::uint32_t first_texel);

  private:
    [[nodiscard]] BindingSet bind_resolver(const Film::Band& band, const Buffer& texels) const;

    Device& device_;
    FilmKernel tracer_;
    Kernel resolver_;
};

}  // namespace utsuri
