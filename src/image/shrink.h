// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

#include <cstdint>

namespace utsuri {

/// The picture at most `most_columns` wide: means over squares of whole pixels, which at the right and bottom
/// edges hold what is left. The picture itself if it is not wider.
/// @param most_columns > 0
[[nodiscard]] Image shrink_to_width(const Image& image, std::uint32_t most_columns);

}  // namespace utsuri
