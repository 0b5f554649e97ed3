// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/textures.h"

#include "import/document/uri.h"

#include "image_io/image_io.h"

#include <span>
#include <utility>
#include <vector>

namespace utsuri {
namespace {

TextureWrap wrap_mode(int code) {
    switch (code) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return TextureWrap::clamp_to_edge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return TextureWrap::mirrored_repeat;
        default:
            return TextureWrap::repeat;
    }
}

/// Without a sampler the slot keeps its defaults, which are glTF's: repeat, and linear as its free choice of
/// filter.
void apply_sampler(const Document& document, int sampler, TextureSlot& slot) {
    if (sampler < 0) return;
    const tinygltf::Sampler& source = document.model.samplers[static_cast<std::size_t>(sampler)];
    slot.wrap_s = wrap_mode(source.wrapS);
    slot.wrap_t = wrap_mode(source.wrapT);
    slot.filter =
        source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? TextureFilter::nearest : TextureFilter::linear;
}

std::string image_name(const nlohmann::json& image, std::size_t index) {
    constexpr std::size_t kMaxUriShown = 256;  // a data: URI is no name
    if (image.contains("name")) return image["name"];
    if (image.contains("uri")) {
        const auto& uri = image["uri"].get_ref<const std::string&>();
        if (uri.size() <= kMaxUriShown && !uri.starts_with("data:")) return percent_decode(uri);
    }
    return fmt::format("images[{}]", index);
}

}  // namespace

TextureSlot TextureImporter::slot(const tinygltf::TextureInfo& info, const std::string& place) {
    TextureSlot slot;
    if (info.index < 0) return slot;
    if (info.texCoord != 0) {
        context_.ignored.add("textures on a texCoord set other than 0 are not drawn", place);
        return slot;
    }
    const tinygltf::Texture& texture = context_.document.model.textures[static_cast<std::size_t>(info.index)];
    if (texture.source < 0) {
        context_.ignored.add("textures without a source image are not drawn", place);
        return slot;
    }
    slot.texture = texture_of_image(static_cast<std::size_t>(texture.source));
    apply_sampler(context_.document, texture.sampler, slot);
    return slot;
}

std::int32_t TextureImporter::texture_of_image(std::size_t image) {
    const auto found = imported_.find(image);
    if (found != imported_.end()) return found->second;
    const Document& document = context_.document;
    const nlohmann::json& source = document.json["images"][image];
    const std::string place = fmt::format("images[{}]", image);
    const bool has_view = source.contains("bufferView");
    if (has_view == source.contains("uri")) {
        document.fail(place, "has both or neither of uri and bufferView; must have one of them");
    }
    std::vector<std::byte> storage;
    std::span<const std::byte> bytes;
    if (has_view) {
        bytes = context_.buffers.view(source["bufferView"]);
    } else {
        storage = read_uri(document.file, source["uri"].get_ref<const std::string&>(), place + ".uri");
        bytes = storage;
    }
    const std::string name = image_name(source, image);
    Texture texture =
        decode_texture(bytes, fmt::format("{}: {} ({})", document.file.path.string(), place, name));
    texture.name = name;
    auto& textures = context_.result.scene.textures;
    textures.push_back(std::move(texture));
    const auto index = static_cast<std::int32_t>(textures.size() - 1);
    imported_.emplace(image, index);
    return index;
}

}  // namespace utsuri
