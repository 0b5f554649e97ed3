// SPDX-License-Identifier: Apache-2.0
#include "import/document/container.h"

#include "base/file.h"

#include <fmt/format.h>

#include <cstdint>

namespace utsuri {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF" read as a little-endian number
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t read_u32(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    }
    return value;
}

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Checks the header and returns the part of the file that the header declares.
std::span<const std::byte> glb_body(const SourceFile& file, std::span<const std::byte> bytes) {
    if (bytes.size() < kHeaderSize) {
        file.fail("",
                  fmt::format("truncated: {} bytes; the header of a .glb has {}", bytes.size(), kHeaderSize));
    }
    const std::uint32_t version = read_u32(bytes, 4);
    if (version != 2) file.fail("", fmt::format("binary container version {}; must be 2", version));
    const std::uint32_t length = read_u32(bytes, 8);
    if (length > bytes.size()) {
        file.fail("",
                  fmt::format("truncated: the header says {} bytes, the file has {}", length, bytes.size()));
    }
    if (length < kHeaderSize) {
        file.fail("", fmt::format("the header says {} bytes; must be at least {}", length, kHeaderSize));
    }
    return bytes.first(length);
}

void split_chunks(const SourceFile& file, std::span<const std::byte> body, Container& container) {
    std::size_t offset = kHeaderSize;
    for (int chunk = 0; offset < body.size(); ++chunk) {
        const std::size_t left = body.size() - offset;
        if (left < kChunkHeaderSize) {
            file.fail("", fmt::format("truncated: {} bytes left for the header of chunk {}; must be {}", left,
                                      chunk, kChunkHeaderSize));
        }
        const std::uint32_t length = read_u32(body, offset);
        const std::uint32_t type = read_u32(body, offset + 4);
        offset += kChunkHeaderSize;
        if (length > body.size() - offset) {
            file.fail("", fmt::format("truncated: chunk {} says {} bytes, {} are left", chunk, length,
                                      body.size() - offset));
        }
        const auto contents = body.subspan(offset, length);
        if (chunk == 0 && type != kJsonChunk) {
            file.fail("", fmt::format("the first chunk has type 0x{:08X}; must be JSON, 0x{:08X}", type,
                                      kJsonChunk));
        }
        if (chunk == 0) container.json = as_text(contents);
        if (chunk == 1 && type == kBinChunk) container.bin = contents;
        offset += length;
    }
    if (container.json.empty()) file.fail("", "no JSON chunk; a .glb must have one");
}

}  // namespace

Container read_container(const SourceFile& file) {
    Container container;
    container.bytes = read_file(file.path, kImportOperation);
    const std::span<const std::byte> bytes = container.bytes;
    if (bytes.empty()) file.fail("", "the file is empty; must be glTF 2.0");
    const std::string extension = file.path.extension().string();
    if (bytes.size() >= 4 && read_u32(bytes, 0) == kGlbMagic) {
        split_chunks(file, glb_body(file, bytes), container);
    } else if (extension == ".glb" || extension == ".GLB") {
        file.fail("", "not a binary glTF file: the first four bytes must be \"glTF\"");
    } else {
        container.json = as_text(bytes);
    }
    return container;
}

}  // namespace utsuri
