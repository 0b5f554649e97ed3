// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

/// A ray that leaves a reflector, and the place where it meets something else. Scene space.
struct ReflectedRay {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< unit
    glm::dvec3 hit;
};

/// Rays that stand for all that an instance can reflect: spread over its area, in directions by their cosine
/// on the front of its surface, or on the open side of a plane mirror. Those that meet nothing, or the
/// instance again, are left out. The same for each call.
/// @param count rays tried
std::vector<ReflectedRay> reflected_rays(const SceneData& scene, std::uint32_t instance, std::uint32_t count);

/// Points spread over the area of an instance, scene space.
struct SurfaceSpread {
    std::vector<glm::dvec3> places;
    double size;  ///< diagonal of the instance's box
};
SurfaceSpread spread_over_surface(const SceneData& scene, std::uint32_t instance, std::uint32_t count);

/// The least distance from a point to other instances along a few dozen directions.
double distance_to_surroundings(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point);

}  // namespace utsuri
