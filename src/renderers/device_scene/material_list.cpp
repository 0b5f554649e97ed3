// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/material_list.h"

#include <algorithm>

namespace utsuri {
namespace {

/// Of the emissive texture, which scales the power of the triangles that use it. Never zero: a light that can
/// shine must be able to be chosen, however dark its texture's mean.
double emissive_factor(const TextureTable& table, std::uint32_t header, std::vector<TextureFacts>& facts) {
    std::optional<double>& mean = facts[header].mean;
    if (!mean) mean = mean_colour(table.texture(header));
    return std::max(*mean, 1.0 / 255.0);
}

}  // namespace

std::vector<interop::MaterialInfo> list_materials(const Scene& scene, const TextureTable& table) {
    std::vector<interop::MaterialInfo> result;
    result.reserve(scene.materials.size());
    for (const Material& material : scene.materials) {
        const float ratio = (material.ior - 1.0f) / (material.ior + 1.0f);
        interop::MaterialInfo info{};
        info.base_colour = material.base_colour;
        info.metallic = material.metallic;
        info.emissive = material.emissive;
        info.roughness = material.roughness;
        info.dielectric_f0 = ratio * ratio * material.specular_colour;
        info.specular = material.specular;
        info.ior = material.ior;
        info.double_sided = material.double_sided ? 1 : 0;
        info.base_colour_texture = table.slot(material.base_colour_texture);
        info.metallic_roughness_texture = table.slot(material.metallic_roughness_texture);
        info.emissive_texture = table.slot(material.emissive_texture);
        info.specular_texture = table.slot(material.specular_texture);
        info.specular_colour_texture = table.slot(material.specular_colour_texture);
        result.push_back(info);
    }
    return result;
}

std::vector<glm::vec3> mean_emission(const Scene& scene, const TextureTable& table,
                                     std::vector<TextureFacts>& facts) {
    std::vector<glm::vec3> result;
    result.reserve(scene.materials.size());
    for (const Material& material : scene.materials) {
        const bool shines = material.emissive != glm::vec3(0.0f);
        const std::uint32_t header = table.slot(material.emissive_texture).texture;
        const double factor = shines && header != interop::NONE ? emissive_factor(table, header, facts) : 1.0;
        result.push_back(material.emissive * static_cast<float>(factor));
    }
    return result;
}

}  // namespace utsuri
