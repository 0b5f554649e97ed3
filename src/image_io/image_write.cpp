// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"
#include "base/error.h"
#include "base/file.h"
#include "image/colour.h"
#include "image/tone.h"
#include "image_io/image_file.h"
#include "image_io/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace utsuri {
namespace {

/// The largest finite half is 65504; from 65520 on, rounding to nearest gives infinity.
constexpr float kHalfOverflow = 65520.0f;

std::vector<std::byte> encode(const std::string& format, const OIIO::ImageSpec& spec,
                              const OIIO::TypeDesc& type, const void* pixels) {
    prepare_image_library();
    std::vector<unsigned char> buffer;
    OIIO::Filesystem::IOVecOutput sink(buffer);
    const auto output = OIIO::ImageOutput::create(format);
    const auto fail = [&](const std::string& message) {
        throw InputError("encode image", "",
                         fmt::format("OpenImageIO cannot make {} x {} pixels of {}: {}", spec.width,
                                     spec.height, format, one_line(message)));
    };
    if (!output) fail(OIIO::geterror());
    output->set_ioproxy(&sink);
    if (!output->open(fmt::format("memory.{}", format), spec) || !output->write_image(type, pixels) ||
        !output->close()) {
        fail(output->geterror());
    }
    std::vector<std::byte> bytes(buffer.size());
    std::memcpy(bytes.data(), buffer.data(), buffer.size());
    return bytes;
}

void write_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
    write_text_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

OIIO::ImageSpec exr_spec(std::uint32_t width, std::uint32_t height, std::vector<std::string> names,
                         ExrPrecision precision, const ImageMetadata& metadata) {
    const OIIO::TypeDesc type(precision == ExrPrecision::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), static_cast<int>(names.size()),
                         type);
    spec.channelnames = std::move(names);
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");
    // Without this the library stores the time of day, and no two files are equal.
    spec.attribute("DateTime", "");
    for (const auto& [key, value] : metadata)
        spec.attribute(key, value);
    return spec;
}

void require_half_range(const std::filesystem::path& path, const Image& image) {
    const auto overflows = [](float value) {
        return std::isfinite(value) && std::abs(value) >= kHalfOverflow;
    };
    const auto count = std::count_if(image.pixels.begin(), image.pixels.end(), [&](const glm::vec3& pixel) {
        return overflows(pixel.x) || overflows(pixel.y) || overflows(pixel.z);
    });
    if (count == 0) return;
    throw UsageError(
        "write image", fmt::format("'{}'", path.string()),
        fmt::format("{} pixels exceed 65504, the largest half-precision value; write single precision",
                    count));
}

std::uint8_t byte_of(float coded) {
    constexpr float kLargest = 255.0f;
    if (!(coded > 0.0f)) return 0;
    return static_cast<std::uint8_t>(std::lround(std::min(coded, 1.0f) * kLargest));
}

}  // namespace

void write_exr(const std::filesystem::path& path, const Image& image, ExrPrecision precision,
               const ImageMetadata& metadata) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    if (precision == ExrPrecision::half) require_half_range(path, image);
    const OIIO::ImageSpec spec = exr_spec(image.width, image.height, {"R", "G", "B"}, precision, metadata);
    write_bytes(path, encode("openexr", spec, OIIO::TypeDesc(OIIO::TypeDesc::FLOAT), image.pixels.data()));
}

void write_exr_channels(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                        const std::vector<ExrChannels>& groups, const ImageMetadata& metadata) {
    std::vector<std::string> names;
    for (const ExrChannels& group : groups)
        names.insert(names.end(), group.names.begin(), group.names.end());
    UTSURI_CHECK_LT(0u, names.size());
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    UTSURI_CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());

    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    std::vector<float> interleaved(pixels * names.size());
    std::size_t first = 0;
    for (const ExrChannels& group : groups) {
        const std::size_t channels = group.names.size();
        for (std::size_t i = 0; i < pixels; ++i) {
            std::copy_n(group.data + i * channels, channels, interleaved.data() + i * names.size() + first);
        }
        first += channels;
    }
    const OIIO::ImageSpec spec = exr_spec(width, height, names, ExrPrecision::single, metadata);
    write_bytes(path, encode("openexr", spec, OIIO::TypeDesc(OIIO::TypeDesc::FLOAT), interleaved.data()));
}

namespace {

/// @param compression as OpenImageIO names it; empty for the format's own
std::vector<std::byte> encode_coded(const std::string& format, const Image& coded,
                                    const std::string& compression) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(coded.pixels.size() * 3);
    for (const glm::vec3& pixel : coded.pixels) {
        for (int c = 0; c < 3; ++c)
            rgb.push_back(byte_of(pixel[c]));
    }
    const OIIO::TypeDesc type(OIIO::TypeDesc::UINT8);
    OIIO::ImageSpec spec(static_cast<int>(coded.width), static_cast<int>(coded.height), 3, type);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (!compression.empty()) spec.attribute("compression", compression);
    return encode(format, spec, type, rgb.data());
}

}  // namespace

std::vector<std::byte> encode_png_coded(const Image& coded) {
    return encode_coded("png", coded, "");
}

std::vector<std::byte> encode_jpeg(const Image& linear, double stops, int quality) {
    return encode_coded("jpeg", to_display(linear, stops), fmt::format("jpeg:{}", quality));
}

std::vector<std::byte> encode_png(const Image& linear, double stops) {
    return encode_png_coded(to_display(linear, stops));
}

void write_png(const std::filesystem::path& path, const Image& linear, double stops) {
    write_bytes(path, encode_png(linear, stops));
}

void write_png_coded(const std::filesystem::path& path, const Image& coded) {
    write_bytes(path, encode_png_coded(coded));
}

}  // namespace utsuri
