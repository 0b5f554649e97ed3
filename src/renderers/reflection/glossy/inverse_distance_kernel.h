// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/film_kernel.h"

#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace utsuri {

/// Measures how far what surrounds a point is, through the texels of a cube of maps.
class InverseDistanceKernel {
  public:
    /// @param inverse_distances one over metres go here, by texel; both must outlive this
    InverseDistanceKernel(Device& device, const GpuScene& scene, const Buffer& inverse_distances);
    InverseDistanceKernel(const InverseDistanceKernel&) = delete;
    InverseDistanceKernel& operator=(const InverseDistanceKernel&) = delete;

    /// Makes the driver compile what the rest needs.
    void warm_up();

    /// @param size texels along an edge of a face
    /// @param excluded_instance that rays go through
    FrameCounts measure(const glm::vec3& point, std::uint32_t size, std::uint32_t excluded_instance);

  private:
    Device& device_;
    Kernel kernel_;
    BindingSet set_;
    DispatchBudget budget_;
};

}  // namespace utsuri
