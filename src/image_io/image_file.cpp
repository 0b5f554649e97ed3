// SPDX-License-Identifier: Apache-2.0
#include "image_io/image_file.h"

#include "base/error.h"
#include "image_io/file_structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <thread>
#include <utility>

namespace utsuri {
namespace {

constexpr int kMaxSide = 65536;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
/// Deflate packs at most 1032 to 1 and the lossy codes of EXR about twice that on a black picture. A header
/// that promises more is false, and must not make us take the memory.
constexpr std::int64_t kMaxExpansion = 4096;
/// Compression of EXR files is the only work of the library that gains from threads.
constexpr unsigned kMaxExrThreads = 4;

struct Signature {
    std::string_view format;
    std::string_view bytes;
};
using namespace std::string_view_literals;
constexpr std::array<Signature, 7> kSignatures{{{"openexr", "\x76\x2f\x31\x01"sv},
                                                {"png", "\x89PNG\r\n\x1a\n"sv},
                                                {"jpeg", "\xff\xd8\xff"sv},
                                                {"hdr", "#?RADIANCE"sv},
                                                {"hdr", "#?RGBE"sv},
                                                {"tiff", "II*\0"sv},
                                                {"tiff", "MM\0*"sv}}};

}  // namespace

void prepare_image_library() {
    static const bool prepared = [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u,
                                                                   kMaxExrThreads)));
        // Known from release 2.5 on; older ones print nothing.
        OIIO::attribute("oiio:print_uncaught_errors", 0);
        static_cast<void>(OIIO::geterror());
        return true;
    }();
    static_cast<void>(prepared);
}

std::string one_line(const std::string& message) {
    std::string line = message;
    std::replace(line.begin(), line.end(), '\n', ' ');
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    return line;
}

std::string_view format_of(std::span<const std::byte> bytes) {
    for (const Signature& signature : kSignatures) {
        if (bytes.size() >= signature.bytes.size() &&
            std::memcmp(bytes.data(), signature.bytes.data(), signature.bytes.size()) == 0) {
            return signature.format;
        }
    }
    return {};
}

ImageFile::ImageFile(std::span<const std::byte> bytes, std::string_view format, std::string operation,
                     std::string object)
    : operation_(std::move(operation)),
      object_(std::move(object)),
      bytes_(checked(bytes, format)),
      source_(bytes_.data(), bytes_.size()) {
    prepare_image_library();
    input_ = OIIO::ImageInput::create(std::string(format));
    if (!input_)
        fail(fmt::format("the installed OpenImageIO does not read {} files: {}", format,
                         one_line(OIIO::geterror())));
    // Straight alpha: dropping alpha, or handing it to a material, must not leave colours multiplied by it.
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    input_->set_ioproxy(&source_);
    if (!input_->open(fmt::format("memory.{}", format), spec_, config)) {
        fail(fmt::format("damaged or cut short, expected a whole {} file ({})", format,
                         one_line(input_->geterror())));
    }
    check_size();
}

std::span<const std::byte> ImageFile::checked(std::span<const std::byte> bytes, std::string_view format) {
    std::string damage;
    if (format == "png") damage = check_png(bytes, essential_);
    if (format == "jpeg") damage = check_jpeg(bytes);
    if (!damage.empty()) fail(fmt::format("damaged or cut short: {}", damage));
    return format == "png" ? std::span<const std::byte>(essential_) : bytes;
}

void ImageFile::check_size() const {
    if (spec_.deep || spec_.depth > 1) fail("deep or volumetric, expected a flat picture");
    if (spec_.width < 1 || spec_.height < 1 || spec_.nchannels < 1) fail("holds no pixels");
    const std::int64_t pixels = std::int64_t{spec_.width} * spec_.height;
    if (spec_.width > kMaxSide || spec_.height > kMaxSide || pixels > kMaxPixels) {
        fail(fmt::format("{} x {} pixels, expected at most {} a side and {} in all", spec_.width,
                         spec_.height, kMaxSide, kMaxPixels));
    }
    if (pixels / kMaxExpansion > static_cast<std::int64_t>(bytes_.size())) {
        fail(fmt::format("{} x {} pixels cannot be in {} bytes: damaged or cut short", spec_.width,
                         spec_.height, bytes_.size()));
    }
}

void ImageFile::read(int begin, int end, const OIIO::TypeDesc& type, void* out, std::size_t pixel_bytes) {
    if (!input_->read_image(0, 0, begin, end, type, out, static_cast<OIIO::stride_t>(pixel_bytes))) {
        fail(fmt::format("damaged or cut short ({})", one_line(input_->geterror())));
    }
}

void ImageFile::fail(std::string_view problem) const {
    throw InputError(operation_, object_, problem);
}

}  // namespace utsuri
