// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/materials.h"

#include <cmath>
#include <string>
#include <utility>

namespace utsuri {
namespace {

using Json = nlohmann::json;

glm::vec3 emissive_luminance(const Document& document, const tinygltf::Material& source, double strength,
                             const std::string& place) {
    glm::vec3 emissive(0.0f);
    for (int c = 0; c < 3; ++c) {
        emissive[c] = static_cast<float>(source.emissiveFactor[static_cast<std::size_t>(c)] * strength);
        if (!std::isfinite(emissive[c])) {
            document.fail(
                place + ".emissiveFactor",
                fmt::format(
                    "times emissiveStrength {} is beyond the range of float32; must be below 3.4e38 cd/m2",
                    strength));
        }
    }
    return emissive;
}

float index_of_refraction(ImportContext& context, double ior, const std::string& place) {
    constexpr double kDefaultIor = 1.5;
    if (ior == 0.0) {
        // The extension gives 0 a meaning of its own: full reflection at every angle.
        context.ignored.add("an ior of 0 (full reflection at every angle) is drawn as 1.5", place);
        return static_cast<float>(kDefaultIor);
    }
    if (ior < 1.0) {
        context.document.fail(place + ".extensions.KHR_materials_ior.ior",
                              fmt::format("is {}; must be 0, or at least 1", ior));
    }
    return static_cast<float>(ior);
}

void note_unused_features(FeatureNotes& ignored, const tinygltf::Material& source, const std::string& place) {
    if (source.normalTexture.index >= 0)
        ignored.add("normal textures are not drawn, surfaces look smooth", place);
    if (source.occlusionTexture.index >= 0) {
        ignored.add("occlusion textures are not used, occlusion is computed", place);
    }
    if (source.alphaMode != "OPAQUE") {
        ignored.add(fmt::format("alphaMode {} is not used, surfaces are drawn opaque", source.alphaMode),
                    place);
    }
}

}  // namespace

std::uint32_t MaterialImporter::material_of(int material) {
    const auto found = imported_.find(material);
    if (found != imported_.end()) return found->second;
    Material imported;
    if (material < 0) {
        imported.name = "default";
    } else {
        imported = read(static_cast<std::size_t>(material));
    }
    auto& materials = context_.result.scene.materials;
    materials.push_back(std::move(imported));
    const auto index = static_cast<std::uint32_t>(materials.size() - 1);
    imported_.emplace(material, index);
    return index;
}

Material MaterialImporter::read(std::size_t index) {
    const Document& document = context_.document;
    const tinygltf::Material& source = document.model.materials[index];
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    const Json& json = document.json["materials"][index];
    const std::string place = fmt::format("materials[{}]", index);
    Material material;
    material.name = source.name.empty() ? place : source.name;
    for (int c = 0; c < 3; ++c) {
        material.base_colour[c] = static_cast<float>(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
    }
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    material.double_sided = source.doubleSided;
    // Extensions are read from the JSON: the parser keeps their integers in 32 bits.
    const double strength =
        extension_of(json, "KHR_materials_emissive_strength").value("emissiveStrength", 1.0);
    material.emissive = emissive_luminance(document, source, strength, place);
    material.ior =
        index_of_refraction(context_, extension_of(json, "KHR_materials_ior").value("ior", 1.5), place);
    const std::string pbr_place = place + ".pbrMetallicRoughness.";
    material.base_colour_texture = textures_.slot(pbr.baseColorTexture, pbr_place + "baseColorTexture");
    material.metallic_roughness_texture =
        textures_.slot(pbr.metallicRoughnessTexture, pbr_place + "metallicRoughnessTexture");
    material.emissive_texture = textures_.slot(source.emissiveTexture, place + ".emissiveTexture");
    leave_out_black_emission(material, place);
    note_unused_features(context_.ignored, source, place);
    read_specular(extension_of(json, "KHR_materials_specular"), material,
                  place + ".extensions.KHR_materials_specular.");
    return material;
}

void MaterialImporter::read_specular(const Json& specular, Material& material, const std::string& place) {
    material.specular = static_cast<float>(specular.value("specularFactor", 1.0));
    const std::vector<double> colour =
        specular.value("specularColorFactor", std::vector<double>{1.0, 1.0, 1.0});
    for (int c = 0; c < 3; ++c)
        material.specular_colour[c] = static_cast<float>(colour[static_cast<std::size_t>(c)]);
    const auto slot = [&](const char* name) {
        tinygltf::TextureInfo info;
        if (const auto found = specular.find(name); found != specular.end()) {
            info.index = found->value("index", -1);
            info.texCoord = found->value("texCoord", 0);
        }
        return textures_.slot(info, place + name);
    };
    material.specular_texture = slot("specularTexture");
    material.specular_colour_texture = slot("specularColorTexture");
}

void MaterialImporter::leave_out_black_emission(Material& material, const std::string& place) {
    if (!material.emissive_texture.used() || material.emissive == glm::vec3(0.0f)) return;
    const Texture& texture =
        context_.result.scene.textures[static_cast<std::size_t>(material.emissive_texture.texture)];
    for (std::size_t byte = 0; byte < texture.rgba.size(); ++byte) {
        if (byte % 4 != 3 && texture.rgba[byte] != 0) return;
    }
    material.emissive = glm::vec3(0.0f);
    material.emissive_texture = {};
    context_.ignored.add("emissive textures that are black all over give no light", place);
}

}  // namespace utsuri
