// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/scene_data.h"

#include "geometry/bounds.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace utsuri {

/// The box, along the axes of the world, that stands in best for what surrounds a reflector: the one with the
/// least mean of |log(distance to the box / distance to the scene)| over directions from the capture point.
/// It holds that point and the reflector. Where nothing surrounds it, the bounds of the scene.
/// @param point capture point, scene space
Bounds fit_proxy_box(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point);

}  // namespace utsuri
