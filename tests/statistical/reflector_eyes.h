// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace utsuri::test {

/// Random eyes that each look at the front of a reflector; none where nothing is reflective.
/// @param data of the scene
std::vector<Camera> eyes_before_reflectors(const Scene& scene, const SceneData& data, std::size_t count,
                                           unsigned seed);

}  // namespace utsuri::test
