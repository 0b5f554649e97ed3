// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "geometry/reference_intersection.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace utsuri {

/// What a ray meets first of all instances but one, found in float64 on the host: the closest hit with 0 < t
/// < t_max. Scene space; distances are in multiples of `direction`. Where surfaces overlap in planes, none is
/// met whose plane holds the origin.
std::optional<ReferenceHit> closest_hit_without(const SceneData& scene, std::uint32_t instance,
                                                const glm::dvec3& origin, const glm::dvec3& direction,
                                                double t_max);

}  // namespace utsuri
