// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

namespace utsuri {

/// Of records without padding.
template <typename Record>
bool same_bytes(const Record& a, const Record& b) {
    static_assert(std::is_trivially_copyable_v<Record>);
    return std::memcmp(&a, &b, sizeof(Record)) == 0;
}

template <typename Record>
bool same_bytes(const std::vector<Record>& a, const std::vector<Record>& b) {
    static_assert(std::is_trivially_copyable_v<Record>);
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Record)) == 0);
}

}  // namespace utsuri
