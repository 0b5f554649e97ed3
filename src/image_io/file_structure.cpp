// SPDX-License-Identifier: Apache-2.0
#include "image_io/file_structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace utsuri {
namespace {

constexpr std::size_t kPngSignature = 8;
constexpr std::size_t kPngHeader = 13;
/// Length, type and checksum around the body of a chunk.
constexpr std::size_t kChunkFrame = 12;
constexpr std::uint32_t kMaxPngSide = 0x7fffffffu;

std::uint32_t big_endian(std::span<const std::byte> file, std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
        value = (value << 8) | std::to_integer<std::uint32_t>(file[at + i]);
    return value;
}

/// CRC-32 of ISO 3309, polynomial 0xedb88320 in reversed bit order.
class Crc32 {
  public:
    Crc32() {
        for (std::uint32_t i = 0; i < table_.size(); ++i) {
            std::uint32_t value = i;
            for (int bit = 0; bit < 8; ++bit)
                value = (value >> 1) ^ ((value & 1u) != 0 ? 0xedb88320u : 0u);
            table_[i] = value;
        }
    }
    [[nodiscard]] std::uint32_t operator()(std::span<const std::byte> bytes) const {
        std::uint32_t crc = 0xffffffffu;
        for (const std::byte byte : bytes) {
            crc = table_[(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xffu] ^ (crc >> 8);
        }
        return ~crc;
    }

  private:
    std::array<std::uint32_t, 256> table_{};
};

struct Chunk {
    std::string_view type;
    std::span<const std::byte> whole;  ///< with its frame
};

/// The chunk at `at`; `damage` says why there is none.
Chunk chunk_at(std::span<const std::byte> file, std::size_t at, const Crc32& crc32, std::string& damage) {
    if (file.size() - at < kChunkFrame) {
        damage = fmt::format("the file ends after {} bytes, before its end chunk", file.size());
        return {};
    }
    const std::size_t length = big_endian(file, at, 4);
    const std::string_view type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
    if (length > file.size() - at - kChunkFrame) {
        damage = fmt::format("the file ends after {} bytes, inside a chunk of {} bytes at {}", file.size(),
                             length, at);
        return {};
    }
    if (crc32(file.subspan(at + 4, 4 + length)) != big_endian(file, at + 8 + length, 4)) {
        damage = fmt::format("the checksum of the chunk at byte {} is wrong", at);
        return {};
    }
    return {type, file.subspan(at, length + kChunkFrame)};
}

/// ISO/IEC 15948, table 11.1: the bit depths of each colour type.
bool is_valid_kind(std::uint32_t depth, std::uint32_t colour) {
    const bool whole_bytes = depth == 8 || depth == 16;
    const bool packed = depth == 1 || depth == 2 || depth == 4;
    switch (colour) {
        case 0:
            return whole_bytes || packed;
        case 3:
            return packed || depth == 8;
        case 2:
        case 4:
        case 6:
            return whole_bytes;
        default:
            return false;
    }
}

bool is_valid_header(const Chunk& chunk) {
    if (chunk.type != "IHDR" || chunk.whole.size() != kPngHeader + kChunkFrame) return false;
    const std::span<const std::byte> body = chunk.whole.subspan(8, kPngHeader);
    const auto side_is_valid = [](std::uint32_t side) { return side > 0 && side <= kMaxPngSide; };
    return side_is_valid(big_endian(body, 0, 4)) && side_is_valid(big_endian(body, 4, 4)) &&
           is_valid_kind(big_endian(body, 8, 1), big_endian(body, 9, 1)) && big_endian(body, 10, 2) == 0 &&
           big_endian(body, 12, 1) <= 1;
}

/// Whether the chunk decides the pixels. gAMA is kept since it can say that the values are linear.
bool is_essential(std::string_view type) {
    constexpr std::array<std::string_view, 6> kEssential{"IHDR", "PLTE", "tRNS", "gAMA", "IDAT", "IEND"};
    return std::find(kEssential.begin(), kEssential.end(), type) != kEssential.end();
}

bool is_standalone_marker(std::uint32_t marker) {
    return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd7);  // TEM and the restarts
}

}  // namespace

std::string check_png(std::span<const std::byte> file, std::vector<std::byte>& essential) {
    const Crc32 crc32;
    std::size_t at = std::min(kPngSignature, file.size());
    essential.assign(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(at));
    bool is_first = true;
    bool has_data = false;
    while (true) {
        std::string damage;
        const Chunk chunk = chunk_at(file, at, crc32, damage);
        if (!damage.empty()) return damage;
        if (is_first && !is_valid_header(chunk)) return "the header is not one of a PNG file";
        is_first = false;
        has_data = has_data || chunk.type == "IDAT";
        if (is_essential(chunk.type))
            essential.insert(essential.end(), chunk.whole.begin(), chunk.whole.end());
        if (chunk.type == "IEND") return has_data ? "" : "there is no pixel data";
        at += chunk.whole.size();
    }
}

std::string check_jpeg(std::span<const std::byte> file) {
    constexpr std::uint32_t kStartOfScan = 0xda;
    constexpr std::uint32_t kEndOfImage = 0xd9;
    std::size_t at = 2;  // after the start marker
    bool in_scan = false;
    while (at + 1 < file.size()) {
        const bool is_prefix = big_endian(file, at, 1) == 0xff;
        const std::uint32_t marker = big_endian(file, at + 1, 1);
        if (!is_prefix && !in_scan) return fmt::format("no segment starts at byte {}", at);
        // In coded data a zero after 0xff makes it data; anywhere, 0xff may be repeated before a marker.
        if (!is_prefix || marker == 0xff || (in_scan && marker == 0x00)) {
            ++at;
            continue;
        }
        if (marker == kEndOfImage) return "";
        at += 2;
        if (is_standalone_marker(marker)) continue;
        if (at + 2 > file.size()) break;
        at += big_endian(file, at, 2);
        in_scan = marker == kStartOfScan;
    }
    return fmt::format("the file ends after {} bytes, before its end marker", file.size());
}

}  // namespace utsuri
