// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/film_kernel.h"
#include "renderers/light/surface_light.h"
#include "renderers/reflection/glossy/inverse_distance_kernel.h"
#include "renderers/reflection/maps/texel_tracer.h"

#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include "interop/glossy_map.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace utsuri {

/// Texels of all faces of a level, borders included.
std::uint64_t prefiltered_texels(std::uint32_t level_size);

/// Where convolved maps go.
struct ConvolvedMaps {
    const Buffer& texels;
    const Buffer& inverse_distances;  ///< of each texel, if they are kept
    bool keeps_distances;
};

/// Captures what surrounds a point, a cube of maps, and convolves it with lobes.
class MapPrefilter {
  public:
    /// @param light filled
    /// @param largest_source most texels along an edge of a face of what is captured, a power of two
    MapPrefilter(Device& device, const GpuScene& scene, const SurfaceLight& light, const ConvolvedMaps& maps,
                 std::uint32_t largest_source);
    MapPrefilter(const MapPrefilter&) = delete;
    MapPrefilter& operator=(const MapPrefilter&) = delete;

    /// Makes the driver compile what the rest needs.
    void warm_up();

    /// @param size texels along an edge of a face, a power of two
    /// @param frame all but its camera; faces take its seed and the ones after it
    FrameCounts capture(const glm::vec3& point, std::uint32_t size, FrameSettings frame,
                        std::uint32_t samples);

    /// Convolves what was captured last.
    /// @param push all but its range of texels, which is found here
    /// @returns seconds on the device
    double convolve(const interop::PrefilterMapPush& push);

    /// Texels of what is captured, with its coarser levels.
    static std::uint64_t source_texels(std::uint32_t size);

  private:
    Device& device_;
    TexelTracer tracer_;
    Kernel halver_;
    Kernel convolver_;
    Buffer source_;
    Buffer inverse_distances_;
    std::optional<InverseDistanceKernel> measurer_;  ///< if distances are kept
    BindingSet halve_set_;
    BindingSet convolve_set_;
    DispatchBudget budget_;  ///< of texels convolved
};

}  // namespace utsuri
