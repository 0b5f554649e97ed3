// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "base/file.h"
#include "image/colour.h"
#include "image_io/image_file.h"
#include "image_io/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace utsuri {
namespace {

using ChannelTriple = std::array<int, 3>;

int find_channel(const OIIO::ImageSpec& spec, char name) {
    for (int i = 0; i < spec.nchannels; ++i) {
        const std::string& candidate = spec.channelnames[static_cast<std::size_t>(i)];
        if (candidate.size() == 1 && std::toupper(static_cast<unsigned char>(candidate[0])) == name) return i;
    }
    return -1;
}

/// The channels named R, G and B; else Y, or the first one or three.
ChannelTriple colour_channels(const OIIO::ImageSpec& spec) {
    const ChannelTriple named{find_channel(spec, 'R'), find_channel(spec, 'G'), find_channel(spec, 'B')};
    if (std::all_of(named.begin(), named.end(), [](int channel) { return channel >= 0; })) return named;
    const int grey = find_channel(spec, 'Y');
    if (grey >= 0) return {grey, grey, grey};
    if (spec.nchannels >= 3) return {0, 1, 2};
    return {0, 0, 0};
}

void read_colours(ImageFile& file, const ChannelTriple& channels, Image& image) {
    const OIIO::TypeDesc type(OIIO::TypeDesc::FLOAT);
    if (channels[1] == channels[0] + 1 && channels[2] == channels[0] + 2) {
        file.read(channels[0], channels[0] + 3, type, image.pixels.data(), sizeof(glm::vec3));
        return;
    }
    if (channels[0] == channels[1] && channels[0] == channels[2]) {
        // Once: to read a PNG or JPEG file again the library would open it by name, and this one is in
        // memory.
        file.read(channels[0], channels[0] + 1, type, image.pixels.data(), sizeof(glm::vec3));
        for (glm::vec3& pixel : image.pixels)
            pixel = glm::vec3(pixel.x);
        return;
    }
    for (int c = 0; c < 3; ++c) {
        const int channel = channels[static_cast<std::size_t>(c)];
        file.read(channel, channel + 1, type, &image.pixels[0][c], sizeof(glm::vec3));
    }
}

bool is_srgb_coded(const OIIO::ImageSpec& spec) {
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const bool says_linear = space == "Linear" || space == "linear" || space == "scene_linear";
    return !spec.format.is_floating_point() && !says_linear;
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
    const std::string operation = "read image";
    const std::string object = fmt::format("'{}'", path.string());
    const std::vector<std::byte> bytes = read_file(path, operation);
    const std::string_view format = format_of(bytes);
    if (format.empty()) {
        throw InputError(operation, object,
                         bytes.empty() ? "the file is empty, expected an image"
                                       : "not an EXR, HDR, TIFF, PNG or JPEG file");
    }
    ImageFile file(bytes, format, operation, object);
    const OIIO::ImageSpec& spec = file.spec();
    Image image(static_cast<std::uint32_t>(spec.width), static_cast<std::uint32_t>(spec.height));
    read_colours(file, colour_channels(spec), image);
    if (is_srgb_coded(spec)) {
        for (glm::vec3& pixel : image.pixels)
            pixel = srgb_decode(pixel);
    }
    return image;
}

Texture decode_texture(std::span<const std::byte> bytes, std::string_view name) {
    const std::string operation = "decode texture";
    const std::string object = fmt::format("'{}'", name);
    const std::string_view format = format_of(bytes);
    if (format != "png" && format != "jpeg") {
        throw InputError(operation, object,
                         bytes.empty() ? "no bytes, expected a PNG or JPEG file"
                                       : "not a PNG or JPEG file, the formats that glTF 2.0 has");
    }
    ImageFile file(bytes, format, operation, object);
    const OIIO::ImageSpec& spec = file.spec();
    const auto channels = static_cast<std::size_t>(std::min(spec.nchannels, 4));
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<std::uint8_t> raw(pixels * channels);
    file.read(0, static_cast<int>(channels), OIIO::TypeDesc(OIIO::TypeDesc::UINT8), raw.data(), channels);

    Texture texture;
    texture.name = name;
    texture.width = static_cast<std::uint32_t>(spec.width);
    texture.height = static_cast<std::uint32_t>(spec.height);
    texture.rgba.resize(pixels * 4);
    const bool grey = channels < 3;
    const bool has_alpha = channels % 2 == 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* source = raw.data() + i * channels;
        std::uint8_t* texel = texture.rgba.data() + i * 4;
        for (std::size_t c = 0; c < 3; ++c)
            texel[c] = source[grey ? 0 : c];
        texel[3] = has_alpha ? source[channels - 1] : std::uint8_t{255};
    }
    return texture;
}

}  // namespace utsuri
