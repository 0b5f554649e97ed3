// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace utsuri {

// libpng prints its complaints on the terminal, and libjpeg pads a file that was cut short with grey: both
// kinds of file are walked before they are decoded.

/// Walks the chunks of a PNG (ISO/IEC 15948): header, lengths, checksums, end. Returns what is wrong, empty
/// if nothing, and in `essential` the same file with the chunks that decide its pixels, without the profiles
/// and texts that libpng warns about.
[[nodiscard]] std::string check_png(std::span<const std::byte> file, std::vector<std::byte>& essential);

/// Walks the segments of a JPEG (ITU-T T.81, annex B) from the start to the end marker. Returns what is
/// wrong, empty if nothing.
[[nodiscard]] std::string check_jpeg(std::span<const std::byte> file);

}  // namespace utsuri
