// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include <string>

namespace utsuri {

/// The comparison as lines of text for a terminal, at most 110 columns.
std::string comparison_table(const Comparison& comparison);

/// Seconds with a unit and three digits: "830 us", "12.3 ms", "4.56 s", "2 min 03 s".
std::string format_seconds(double seconds);
/// Bytes with a binary unit and three digits: "1.23 MiB".
std::string format_bytes(std::uint64_t bytes);
/// Counts with a decimal unit and three digits: "12.3 M".
std::string format_count(double count);

}  // namespace utsuri
