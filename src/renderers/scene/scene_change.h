// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/scene/scene_data.h"

#include <cstdint>
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
    bool surroundings = false;  ///< the uniform surroundings shine otherwise
    bool rebuilt = false;

    [[nodiscard]] bool empty() const { return triangles.empty() && !lights && !surroundings; }
};

/// Makes the data of a scene those of the scene as it is now: its instances moved, its lights, materials or
/// surroundings of other values. Meshes, which material an instance has, and textures are to be the same.
/// Renderers follow with Renderer::follow(), after GpuScene::update().
/// @throws InputError if what it takes to render the scene has changed: a light was switched off or on, a
/// matt material made a mirror; `data` is then as before, and the scene has to be prepared anew
SceneChange update_scene_data(SceneData& data, const Scene& scene);

}  // namespace utsuri
