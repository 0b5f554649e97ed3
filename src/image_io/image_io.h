// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "scene/texture.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace utsuri {

/// A picture from an EXR, Radiance HDR, TIFF, PNG or JPEG file, told apart by content and not by name.
/// Floating-point values are taken as they are; integer values are decoded from sRGB unless the file says
/// that they are linear. Grey becomes three equal channels; alpha and further channels are dropped; of
/// several pictures the first is read.
/// @throws InputError naming the file if it is missing, a folder, of another format, damaged, cut short,
/// deep, or larger than 65536 pixels a side or 2^28 pixels.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

/// Texels from the bytes of a PNG or JPEG file, the formats of glTF 2.0. Values stay as coded in the file,
/// alpha unassociated; 16 bits are rounded to 8; grey becomes three equal channels; a missing alpha becomes
/// 255. `name` stands for the texture in messages and becomes Texture::name.
/// @throws InputError as read_image.
[[nodiscard]] Texture decode_texture(std::span<const std::byte> bytes, std::string_view name);

/// Text attributes of a file: key and value.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// How an EXR file stores a value: `half` has 11 significant bits and ends at 65504.
enum class ExrPrecision { half, single };

/// Writes linear values with lossless compression; equal pictures give equal files. The file appears whole or
/// not at all. @throws InputError if it cannot be written, UsageError if a finite value does not fit into
/// `half`.
void write_exr(const std::filesystem::path& path, const Image& image, ExrPrecision precision,
               const ImageMetadata& metadata = {});

/// A group of channels, interleaved: width * height * names.size() values, top row first.
struct ExrChannels {
    std::vector<std::string> names;  ///< as in the file, for example {"normal.X", "normal.Y", "normal.Z"}
    const float* data = nullptr;
};

/// Writes groups of channels into one EXR file of floats, for example radiance ("R", "G", "B") and auxiliary
/// outputs.
/// @pre at least one group; no name twice. @throws InputError if the file cannot be written.
void write_exr_channels(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                        const std::vector<ExrChannels>& groups, const ImageMetadata& metadata = {});

/// An 8-bit sRGB PNG of linear values after `stops` of exposure (to_display of image/tone.h), rounded to
/// nearest.
[[nodiscard]] std::vector<std::byte> encode_png(const Image& linear, double stops);

/// An 8-bit PNG of values that are display coded already, such as error maps; clamped to [0, 1], rounded to
/// nearest, not-a-number as 0.
[[nodiscard]] std::vector<std::byte> encode_png_coded(const Image& coded);

/// An 8-bit sRGB JPEG likewise, for pages that show many pictures.
/// @param quality 1 to 100
[[nodiscard]] std::vector<std::byte> encode_jpeg(const Image& linear, double stops, int quality);

/// encode_png into a file that appears whole or not at all. @throws InputError if it cannot be written.
void write_png(const std::filesystem::path& path, const Image& linear, double stops);

/// encode_png_coded into a file, likewise.
void write_png_coded(const std::filesystem::path& path, const Image& coded);

}  // namespace utsuri
