// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/texture_table.h"

#include "base/check.h"
#include "base/same_bits.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

namespace utsuri {
namespace {

static_assert(static_cast<std::uint32_t>(TextureWrap::clamp_to_edge) == interop::TEXTURE_CLAMP_TO_EDGE);
static_assert(static_cast<std::uint32_t>(TextureWrap::mirrored_repeat) == interop::TEXTURE_MIRRORED_REPEAT);

// A word of RGBA8 with red in its lowest byte is then what a texture's bytes are.
static_assert(std::endian::native == std::endian::little);

std::span<std::byte> texels_of(SceneData& data, std::size_t header, const Texture& texture) {
    return std::as_writable_bytes(std::span(data.texels))
        .subspan(std::size_t{data.texture_headers[header].first_texel} * sizeof(std::uint32_t),
                 texture.rgba.size());
}

/// Into the place of a texture of the same size.
void write_texture(const Texture& texture, std::size_t header, SceneData& data, TextureChange& change) {
    const std::span<const std::byte> now = std::as_bytes(std::span(texture.rgba));
    const std::span<std::byte> packed = texels_of(data, header, texture);
    const std::vector<ByteRange> ranges = differing_ranges(packed, now);
    if (ranges.empty()) return;
    const std::uint64_t first =
        std::uint64_t{data.texture_headers[header].first_texel} * sizeof(std::uint32_t);
    for (const ByteRange& range : ranges) {
        std::memcpy(packed.data() + range.offset, now.data() + range.offset, range.size);
        change.ranges.push_back({first + range.offset, range.size});
    }
    change.textures[header] = true;
    data.texture_facts[header] = {};
}

}  // namespace

TextureTable::TextureTable(const Scene& scene)
    : scene_(scene), indices_(scene.textures.size(), interop::NONE) {
    for (const Material& material : scene.materials) {
        for (const TextureSlot* slot : texture_slots(material))
            add(*slot);
    }
}

void TextureTable::add(const TextureSlot& slot) {
    if (!slot.used()) return;
    const auto source = static_cast<std::uint32_t>(slot.texture);
    if (indices_[source] != interop::NONE) return;
    indices_[source] = static_cast<std::uint32_t>(headers_.size());
    const Texture& texture = scene_.textures[source];
    UTSURI_CHECK_EQ(texture.rgba.size(), 4 * std::size_t{texture.width} * texture.height);
    headers_.push_back({static_cast<std::uint32_t>(texels_), texture.width, texture.height});
    sources_.push_back(source);
    texels_ += texture.rgba.size() / 4;
}

const Texture& TextureTable::texture(std::size_t header) const {
    return scene_.textures[sources_[header]];
}

interop::TextureSlotInfo TextureTable::slot(const TextureSlot& slot) const {
    if (!slot.used()) return {interop::NONE, 0, 0, 0, 0};
    const std::uint32_t index = indices_[static_cast<std::size_t>(slot.texture)];
    const TextureHeader& header = headers_[index];
    const std::uint32_t sampling = static_cast<std::uint32_t>(slot.wrap_s) |
                                   (static_cast<std::uint32_t>(slot.wrap_t) << interop::TEXTURE_WRAP_BITS) |
                                   (slot.filter == TextureFilter::linear ? interop::TEXTURE_LINEAR : 0);
    return {index, sampling, header.first_texel, header.width, header.height};
}

TextureChange pack_textures(const TextureTable& table, SceneData& data) {
    TextureChange change;
    const std::size_t count = table.headers().size();
    change.laid_out = !same_bits(table.headers(), data.texture_headers);
    change.textures.resize(count, change.laid_out);
    if (!change.laid_out) {
        for (std::size_t i = 0; i < count; ++i)
            write_texture(table.texture(i), i, data, change);
        return change;
    }
    data.texture_headers = table.headers();
    data.texture_facts.assign(count, {});
    data.texels.clear();  // what is in it need not go along where it grows
    data.texels.resize(table.texels());
    for (std::size_t i = 0; i < count; ++i) {
        const std::vector<std::uint8_t>& rgba = table.texture(i).rgba;
        if (!rgba.empty()) std::memcpy(texels_of(data, i, table.texture(i)).data(), rgba.data(), rgba.size());
    }
    return change;
}

Requirements find_requirements_but_depth(const Scene& scene, const TextureTable& table,
                                         std::vector<TextureFacts>& facts) {
    TextureRanges ranges(scene.textures.size());
    for (std::size_t i = 0; i < facts.size(); ++i)
        ranges[table.source(i)] = facts[i].range;
    Requirements needs = find_requirements_but_depth(scene, ranges);
    for (std::size_t i = 0; i < facts.size(); ++i)
        facts[i].range = ranges[table.source(i)];
    return needs;
}

double mean_colour(const Texture& texture) {
    std::array<double, 256> decoded{};
    for (std::size_t byte = 0; byte < decoded.size(); ++byte)
        decoded[byte] = std::pow(static_cast<double>(byte) / 255.0, 2.2);
    double sum = 0.0;
    for (std::size_t i = 0; i < texture.rgba.size(); ++i) {
        if (i % 4 != 3) sum += decoded[texture.rgba[i]];
    }
    return sum / (0.75 * static_cast<double>(texture.rgba.size()));
}

}  // namespace utsuri
