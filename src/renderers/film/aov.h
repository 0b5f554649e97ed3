// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"

#include "image/image.h"

#include "interop/frame.h"

#include <vector>

namespace utsuri {

/// First hits through the pixel centres, row-major, top row first. Positions are relative to the scene's
/// origin.
std::vector<interop::AovPixel> render_aovs(Device& device, const GpuScene& scene,
                                           const interop::CameraInfo& camera, std::uint32_t width,
                                           std::uint32_t height);

/// Pixels whose first hit is a perfect mirror or smooth dielectric.
Mask reflective_mask(const std::vector<interop::AovPixel>& aovs);

}  // namespace utsuri
