// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_data.h"

#include "renderers/device_scene/light_list.h"
#include "renderers/device_scene/material_list.h"
#include "renderers/device_scene/scene_buffers.h"
#include "renderers/device_scene/scene_geometry.h"
#include "renderers/device_scene/texture_table.h"

#include <algorithm>

namespace utsuri {

SceneData prepare_scene_data(const Scene& scene) {
    SceneData data;
    const TextureTable table(scene);
    pack_textures(table, data);
    data.requirements = find_requirements_but_depth(scene, table, data.texture_facts);
    data.requirements.max_depth = find_max_depth(scene, data.requirements);
    make_geometry(scene, data);
    data.materials = list_materials(scene, table);
    list_lights(scene, mean_emission(scene, table, data.texture_facts), data);
    return data;
}

std::optional<std::uint32_t> SceneData::environment_light() const {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (lights[i].type == interop::LIGHT_ENVIRONMENT) return i;
    }
    return std::nullopt;
}

std::uint32_t SceneData::infinite_lights() const {
    return static_cast<std::uint32_t>(std::count_if(lights.begin(), lights.end(), [](const auto& light) {
        return light.type == interop::LIGHT_ENVIRONMENT || light.type == interop::LIGHT_DIRECTIONAL;
    }));
}

std::uint64_t SceneData::device_bytes() const {
    std::uint64_t bytes = 0;
    for (const SceneBuffer& buffer : scene_buffers(*this))
        bytes += buffer.bytes.size();
    return bytes;
}

}  // namespace utsuri
