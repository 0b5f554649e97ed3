// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <array>
#include <cstdint>
#include <vector>

namespace utsuri {

/// Triangles that reflect in one plane, on both of its sides. Lengths are in scene space.
struct PlaneMirror {
    glm::dvec3 normal{0.0};  ///< unit; the plane is dot(normal, x) = offset
    double offset = 0.0;
    double tolerance = 0.0;                ///< distance from the plane that rounding explains
    std::array<glm::dvec3, 4> outline;     ///< a rectangle in the plane around all of it, its corners in turn
    std::vector<std::uint32_t> triangles;  ///< ascending
};

/// The mirrors of a scene: what lies in planes, and what does not.
struct PlaneMirrors {
    std::vector<PlaneMirror> mirrors;
    std::vector<std::uint32_t>
        others;  ///< triangles that may reflect like a mirror, but in no plane; ascending
};

/// Plane mirrors that are told apart, at most; what is left over counts as curved.
inline constexpr std::size_t kMostPlaneMirrors = 64;

/// Sorts the triangles of a scene that may reflect like a mirror into planes, of whatever instance they are.
/// The largest triangles come first, each with all others in its plane. Vertices lie in it, and their shading
/// normals along its normal, up to the rounding of float32.
PlaneMirrors find_plane_mirrors(const SceneData& scene);

}  // namespace utsuri
