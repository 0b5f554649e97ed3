// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace utsuri {

/// The plane dot(normal, x) = distance, scene space.
struct ReflectorPlane {
    glm::dvec3 normal;  ///< unit, towards the side from which more of the scene is seen
    double distance;
};

/// The plane of a reflective instance, if all its triangles lie in one: what is behind that is never
/// mirrored.
std::optional<ReflectorPlane> plane_of(const SceneData& scene, std::uint32_t instance);

}  // namespace utsuri
