// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/changed_bytes.h"

#include "base/check.h"

#include <algorithm>
#include <cstring>

namespace utsuri {
namespace {

/// From the first to the last byte that differs, of arrays that differ.
ByteRange trimmed(std::span<const std::byte> before, std::span<const std::byte> after) {
    const auto first = std::mismatch(before.begin(), before.end(), after.begin()).first - before.begin();
    const auto last = std::mismatch(before.rbegin(), before.rend(), after.rbegin()).first - before.rbegin();
    return {static_cast<std::uint64_t>(first),
            before.size() - static_cast<std::uint64_t>(first) - static_cast<std::uint64_t>(last)};
}

}  // namespace

std::vector<ByteRange> differing_ranges(std::span<const std::byte> before, std::span<const std::byte> after) {
    UTSURI_CHECK_EQ(before.size(), after.size());
    std::vector<ByteRange> ranges;
    for (std::uint64_t start = 0; start < before.size(); start += kLeastGap) {
        const std::uint64_t size = std::min<std::uint64_t>(kLeastGap, before.size() - start);
        if (std::memcmp(before.data() + start, after.data() + start, size) == 0) continue;
        const ByteRange in_block = trimmed(before.subspan(start, size), after.subspan(start, size));
        const ByteRange range{start + in_block.offset, in_block.size};
        if (!ranges.empty() && range.offset - (ranges.back().offset + ranges.back().size) < kLeastGap) {
            ranges.back().size = range.offset + range.size - ranges.back().offset;
        } else {
            ranges.push_back(range);
        }
    }
    return ranges;
}

}  // namespace utsuri
