// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/source_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// RFC 3986, section 2.1. A percent sign that is not followed by two hexadecimal digits stays as it is.
std::string percent_decode(std::string_view text);

/// The bytes that `uri` names: a data: URI (RFC 2397), or a file, relative to the folder of the glTF file.
/// `place` is the JSON path of the uri.
/// @throws InputError naming `place` if the file cannot be read, or the data or the scheme is not understood.
std::vector<std::byte> read_uri(const SourceFile& file, std::string_view uri, std::string_view place);

}  // namespace utsuri
