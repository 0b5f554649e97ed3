// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"

#include "interop/rays.h"

#include <span>
#include <vector>

namespace utsuri {

enum class RayQuery { closest_hit, any_hit };

/// Traces lists of rays through a scene: the search alone, without shading.
class RayList {
  public:
    RayList(Device& device, const GpuScene& scene, RayQuery query);

    /// The rays that following trace() calls trace.
    void upload(std::span<const interop::RayInfo> rays);
    /// @return seconds on the device
    double trace();
    /// Hits of the last trace(), in the order of the rays. An any-hit query tells one hit, not the closest.
    [[nodiscard]] std::vector<interop::HitInfo> hits() const;

  private:
    Device& device_;
    const GpuScene& scene_;
    Kernel kernel_;
    std::uint32_t count_ = 0;
    std::optional<Buffer> rays_;
    std::optional<Buffer> hits_;
};

}  // namespace utsuri
