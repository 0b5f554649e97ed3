// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/texture.h"

#include <glm/vec3.hpp>

#include <array>
#include <string>

namespace utsuri {

/// The glTF 2.0 metallic-roughness material (specification, appendix B) with KHR_materials_ior, _specular and
/// _emissive_strength. Defaults are glTF's.
struct Material {
    std::string name;
    glm::vec3 base_colour{1.0f};  ///< linear Rec.709, each in [0, 1]
    float metallic = 1.0f;        ///< [0, 1]
    float roughness = 1.0f;       ///< perceptual, [0, 1]; GGX alpha = roughness squared
    glm::vec3 emissive{0.0f};     ///< cd/m2 per channel, emissive strength included, >= 0
    float ior = 1.5f;             ///< index of refraction of the dielectric part, >= 1
    float specular = 1.0f;  ///< [0, 1], scales the dielectric reflection; 0 makes a pure Lambert surface
    /// Scales the dielectric's reflection at normal incidence, which is at most 1; linear Rec.709, >= 0.
    glm::vec3 specular_colour{1.0f};
    /// Emits from the back too; all surfaces block and reflect light on both sides.
    bool double_sided = false;

    TextureSlot base_colour_texture;         ///< sRGB
    TextureSlot metallic_roughness_texture;  ///< linear; g roughness, b metallic
    TextureSlot emissive_texture;            ///< sRGB
    TextureSlot specular_texture;            ///< linear; alpha scales `specular`
    TextureSlot specular_colour_texture;     ///< sRGB
};

/// The textures of a material, in use or not.
inline std::array<const TextureSlot*, 5> texture_slots(const Material& material) {
    return {&material.base_colour_texture, &material.metallic_roughness_texture, &material.emissive_texture,
            &material.specular_texture, &material.specular_colour_texture};
}

inline bool has_texture(const Material& material) {
    for (const TextureSlot* slot : texture_slots(material)) {
        if (slot->used()) return true;
    }
    return false;
}

}  // namespace utsuri
