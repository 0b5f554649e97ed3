// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include <span>

namespace utsuri {

/// Lists the lights of a scene that has its geometry and materials, with the tree they are chosen by, and
/// tells its triangles which of them they are.
/// @param emission mean over its surface of what each material sends out, cd/m2 per channel
void list_lights(const Scene& scene, std::span<const glm::vec3> emission, SceneData& data);

}  // namespace utsuri
