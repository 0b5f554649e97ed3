// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace utsuri {

/// Whether records agree to the bit: zeros of either sign differ, a NaN equals itself. For records without
/// padding, whose bytes are all of its members'.
template <typename Record>
requires std::is_trivially_copyable_v<Record>
bool same_bits(const Record& a, const Record& b) {
    using Bytes = std::array<std::byte, sizeof(Record)>;
    return std::bit_cast<Bytes>(a) == std::bit_cast<Bytes>(b);
}

/// The same of as many records each.
template <typename Record>
requires std::is_trivially_copyable_v<Record>
bool same_bits(const std::vector<Record>& a, const std::vector<Record>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Record)) == 0);
}

}  // namespace utsuri
