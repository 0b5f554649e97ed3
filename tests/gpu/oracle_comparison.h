// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/device.h"
#include "scene/scene.h"

#include "interop/rays.h"

#include <vector>

namespace utsuri::test {

/// Rays of one kind through a scene.
struct RaySet {
    const char* kind;
    std::vector<interop::RayInfo> rays;
};

/// Traces 2^18 rays of four kinds through a scene on the device and with Embree: like those of a camera, from
/// anywhere to anywhere, along axes and diagonals from the planes of BVH boxes, and at edges and vertices.
/// Fails the test where the device's hit is beyond float32 rounding of the truth, found in float64.
void compare_with_embree(Device& device, const Scene& scene);

}  // namespace utsuri::test
