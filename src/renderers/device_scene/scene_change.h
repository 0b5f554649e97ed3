// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <cstdint>
#include <string>
#include <vector>

namespace utsuri {

/// What a change of a scene changed.
struct SceneChange {
    std::vector<std::uint32_t> triangles;  ///< that moved, turned their normals, or look otherwise; ascending
    std::vector<interop::BvhTriangle> before;  ///< where each of them was
    bool geometry = false;                     ///< some triangle moved or turned its normals
    /// Some light shines otherwise or elsewhere, is chosen more or less often, or falls on surfaces that
    /// became diffuse or ceased to be.
    bool lights = false;
    bool environment = false;  ///< the environment shines otherwise
    /// What was made from the scene's requirements no longer holds: sizes of buffers, constants of kernels,
    /// numbers of triangles. Whoever keeps anything about the scene must make it anew, bindings included.
    /// There are then no triangles in the lists, and all that may have changed counts as changed.
    bool rebuilt = false;
    std::string reason;  ///< why, for messages: "it now has 3 lights that shine where it had 2"

    [[nodiscard]] bool empty() const { return triangles.empty() && !lights && !environment && !rebuilt; }
};

/// Makes the data of a scene those of the scene as it is now, whatever has changed. What did not is neither
/// made again nor copied: a colour costs a comparison of meshes and texels with what was packed, but no
/// geometry; only textures that differ are packed. Triangles keep their numbers unless the change is
/// `rebuilt`; the BVH is refitted, or built anew where there are other triangles. Renderers follow with
/// Renderer::update(), after GpuScene::update(). After an exception the data must not be used.
/// @param scene valid: check_scene()
SceneChange update_scene_data(SceneData& data, const Scene& scene);

}  // namespace utsuri
