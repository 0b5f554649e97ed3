// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// Sets the library's process-wide options once: few threads, no messages of its own.
void prepare_image_library();

/// The library's last message in one line, for the end of an error message.
[[nodiscard]] std::string one_line(const std::string& message);

/// OpenImageIO's name of a file format by its first bytes; empty if it is none that is read here.
[[nodiscard]] std::string_view format_of(std::span<const std::byte> bytes);

/// An image file in memory, opened, its size checked. The bytes outlive it.
class ImageFile {
  public:
    /// `operation` and `object` begin every error message. @throws InputError
    ImageFile(std::span<const std::byte> bytes, std::string_view format, std::string operation,
              std::string object);

    [[nodiscard]] const OIIO::ImageSpec& spec() const { return spec_; }

    /// Reads channels [begin, end) of the whole picture as `type`; successive pixels lie `pixel_bytes` apart.
    /// @throws InputError
    void read(int begin, int end, const OIIO::TypeDesc& type, void* out, std::size_t pixel_bytes);

    [[noreturn]] void fail(std::string_view problem) const;

  private:
    /// The bytes to decode, checked where the decoder's own check is too weak or too loud.
    [[nodiscard]] std::span<const std::byte> checked(std::span<const std::byte> bytes,
                                                     std::string_view format);
    void check_size() const;

    std::string operation_;
    std::string object_;
    std::vector<std::byte> essential_;  ///< a PNG without the chunks that do not decide its pixels
    std::span<const std::byte> bytes_;
    OIIO::Filesystem::IOMemReader source_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
};

}  // namespace utsuri
