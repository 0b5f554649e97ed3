// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/camera.h"

#include "interop/frame.h"

#include <cstdint>

namespace utsuri {

/// The camera as kernels take it: relative to the scene's origin, its axes scaled to the edges of the
/// picture.
interop::CameraInfo make_camera_info(const Camera& camera, const glm::dvec3& scene_origin,
                                     std::uint32_t width, std::uint32_t height);

}  // namespace utsuri
