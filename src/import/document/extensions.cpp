// SPDX-License-Identifier: Apache-2.0
#include "import/document/extensions.h"

#include "import/document/place.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace utsuri {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 5> kSupported = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_specular",
    "KHR_mesh_quantization"};

struct Effect {
    std::string_view extension;
    std::string_view text;
};

/// What leaving a well-known extension out changes in the picture.
constexpr std::array kEffects = {
    Effect{"KHR_materials_transmission", "transparent surfaces are drawn opaque"},
    Effect{"KHR_materials_volume", "media inside objects are not drawn"},
    Effect{"KHR_materials_diffuse_transmission", "thin surfaces let no light through"},
    Effect{"KHR_materials_clearcoat", "clear coats are not drawn"},
    Effect{"KHR_materials_sheen", "the sheen of cloth is not drawn"},
    Effect{"KHR_materials_iridescence", "thin-film colours are not drawn"},
    Effect{"KHR_materials_anisotropy", "highlights are round"},
    Effect{"KHR_materials_dispersion", "refraction has no colour fringes"},
    Effect{"KHR_materials_unlit", "unlit surfaces are lit"},
    Effect{"KHR_materials_pbrSpecularGlossiness", "the metallic-roughness values are drawn instead"},
    Effect{"KHR_materials_variants", "the default variant is drawn"},
    Effect{"KHR_texture_transform", "textures are drawn without offset, rotation and scale"},
    Effect{"KHR_texture_basisu", "the fallback image is drawn, if there is one"},
    Effect{"EXT_texture_webp", "the fallback image is drawn, if there is one"},
    Effect{"KHR_draco_mesh_compression", "the uncompressed copy is drawn"},
    Effect{"EXT_meshopt_compression", "the uncompressed copy is drawn"},
    Effect{"EXT_mesh_gpu_instancing", "one copy is drawn of each instanced mesh"},
    Effect{"EXT_lights_image_based", "light from the environment is missing"},
    Effect{"KHR_animation_pointer", "the scene is drawn at rest"},
    Effect{"KHR_node_visibility", "hidden nodes are drawn"},
};

bool is_supported(std::string_view name) {
    return std::find(kSupported.begin(), kSupported.end(), name) != kSupported.end();
}

std::string feature_text(const std::string& name) {
    const auto known = std::find_if(kEffects.begin(), kEffects.end(),
                                    [&](const Effect& effect) { return effect.extension == name; });
    if (known == kEffects.end()) return fmt::format("extension {} is not supported", name);
    return fmt::format("extension {} is not supported ({})", name, known->text);
}

class ExtensionFinder {
  public:
    explicit ExtensionFinder(FeatureNotes& ignored) : ignored_(ignored) {}

    void visit(const Json& value, const Place& place) {
        if (value.is_array()) {
            for (std::size_t i = 0; i < value.size(); ++i) {
                if (value[i].is_structured()) visit(value[i], place.element(i));
            }
        } else if (value.is_object()) {
            for (const auto& [key, member] : value.items()) {
                if (key == "extras" || !member.is_structured()) continue;
                if (key == "extensions" && member.is_object()) note(member, place);
                visit(member, place.member(key));
            }
        }
    }

    [[nodiscard]] const std::set<std::string>& found() const { return found_; }

  private:
    void note(const Json& extensions, const Place& place) {
        const std::string where = place.text();
        for (const auto& [name, contents] : extensions.items()) {
            if (is_supported(name)) continue;
            found_.insert(name);
            ignored_.add(feature_text(name), where.empty() ? "the file as a whole" : where);
        }
    }

    FeatureNotes& ignored_;
    std::set<std::string> found_;
};

}  // namespace

void check_required_extensions(const SourceFile& file, const Json& root) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end()) return;
    if (!required->is_array()) file.fail("extensionsRequired", "is not an array; must be an array of names");
    for (std::size_t i = 0; i < required->size(); ++i) {
        const Json& name = (*required)[i];
        const std::string place = fmt::format("extensionsRequired[{}]", i);
        if (!name.is_string()) file.fail(place, "is not a string; must be the name of an extension");
        if (!is_supported(name.get_ref<const std::string&>())) {
            file.fail(place, fmt::format("{} is required but not supported; supported are {}",
                                         name.get<std::string>(), fmt::join(kSupported, ", ")));
        }
    }
}

void note_unused_extensions(const Json& root, FeatureNotes& ignored) {
    ExtensionFinder finder(ignored);
    finder.visit(root, Place());
    const Json used = root.value("extensionsUsed", Json::array());
    for (std::size_t i = 0; i < used.size(); ++i) {
        const std::string name = used[i];
        if (!is_supported(name) && finder.found().count(name) == 0) {
            ignored.add(feature_text(name), fmt::format("extensionsUsed[{}]", i));
        }
    }
}

}  // namespace utsuri
