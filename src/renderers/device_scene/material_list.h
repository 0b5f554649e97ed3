// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/texture_table.h"

#include <vector>

namespace utsuri {

/// The scene's materials as kernels read them, in its order.
std::vector<interop::MaterialInfo> list_materials(const Scene& scene, const TextureTable& table);

/// What each material sends out, cd/m2 per channel: the mean over the texels of its emissive texture, if it
/// has one. Zero only where it sends out nothing.
/// @param facts of the table's textures; means that are asked for and missing are found and put there
std::vector<glm::vec3> mean_emission(const Scene& scene, const TextureTable& table,
                                     std::vector<TextureFacts>& facts);

}  // namespace utsuri
