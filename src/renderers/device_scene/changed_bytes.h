// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// Bytes of a buffer from an offset on.
struct ByteRange {
    std::uint64_t offset = 0;
    std::uint64_t size = 0;

    friend bool operator==(const ByteRange&, const ByteRange&) = default;
};

/// What a change of a scene did to one of its buffers.
struct ChangedBytes {
    bool resized = false;           ///< all of it is new
    std::vector<ByteRange> ranges;  ///< that differ, ascending; none if resized

    friend bool operator==(const ChangedBytes&, const ChangedBytes&) = default;
};

/// Ranges less than this apart are one: a copy that is begun costs about as much as this many bytes more.
inline constexpr std::uint64_t kLeastGap = 4096;

/// The ranges in which two arrays of one size differ, ascending.
std::vector<ByteRange> differing_ranges(std::span<const std::byte> before, std::span<const std::byte> after);

}  // namespace utsuri
