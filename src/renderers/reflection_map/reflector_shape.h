// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/scene_data.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace utsuri {

/// The plane dot(normal, x) = distance, scene space.
struct MirrorPlane {
    glm::dvec3 normal;  ///< unit, towards the side from which more of the scene is seen
    double distance;
};

/// What the shape of a reflective instance says about the rays that leave it.
struct ReflectorShape {
    /// Set if all its triangles lie in one plane: what is behind that is never mirrored.
    std::optional<MirrorPlane> plane;
    /// Whether no ray that leaves its surface can meet it again: it is flat, or no vertex lies outside any of
    /// its triangles.
    bool convex = false;
};

/// Shapes of more pairs of a vertex and a triangle than this, some tenths of a second of work, count as not
/// convex: the test takes them all.
inline constexpr std::uint64_t kMostConvexityPairs = 200'000'000;

ReflectorShape describe_shape(const SceneData& scene, std::uint32_t instance);

}  // namespace utsuri
