// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <glm/vec3.hpp>

namespace utsuri {

/// Where to capture the maps of a reflective instance, in scene space: the centre of its box. If that lies
/// inside other geometry while the instance itself is exposed, the nearest way out is taken.
glm::dvec3 find_capture_point(const SceneData& scene, std::uint32_t instance);

/// Whether a point lies inside closed geometry other than `instance`: most of what it sees are backs of
/// surfaces.
bool is_inside_geometry(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point);

}  // namespace utsuri
