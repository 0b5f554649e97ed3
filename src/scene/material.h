// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/texture.h"

#include <glm/vec3.hpp>

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
    bool double_sided =
        false;  ///< emits from the back too; all surfaces block and reflect light on both sides

    TextureSlot base_colour_texture;         ///< sRGB
    TextureSlot metallic_roughness_texture;  ///< linear; g roughness, b metallic
    TextureSlot emissive_texture;            ///< sRGB
};

}  // namespace utsuri
