// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace utsuri::test {

using Bytes = std::vector<std::uint8_t>;

inline void append_big_endian(Bytes& out, std::uint32_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i)
        out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

/// CRC-32 of ISO 3309 and Adler-32 of RFC 1950, bit by bit.
inline std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 0; i < size; ++i) {
        crc ^= data[i];
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

inline std::uint32_t adler32(const Bytes& data) {
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : data) {
        a = (a + byte) % 65521u;
        b = (b + a) % 65521u;
    }
    return (b << 16) | a;
}

inline void append_chunk(Bytes& png, std::string_view type, const Bytes& body) {
    append_big_endian(png, static_cast<std::uint32_t>(body.size()), 4);
    const std::size_t start = png.size();
    png.insert(png.end(), type.begin(), type.end());
    png.insert(png.end(), body.begin(), body.end());
    append_big_endian(png, crc32(png.data() + start, png.size() - start), 4);
}

struct PngKind {
    std::uint8_t depth;   ///< bits
    std::uint8_t colour;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
};

/// A PNG whose declared size need not fit its samples; `samples` are the bytes of the rows, without filter
/// bytes.
inline Bytes make_png(std::uint32_t width, std::uint32_t height, PngKind kind, const Bytes& samples,
                      std::size_t row_bytes, const Bytes& palette = {}) {
    Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    append_big_endian(header, width, 4);
    append_big_endian(header, height, 4);
    header.insert(header.end(), {kind.depth, kind.colour, 0, 0, 0});
    append_chunk(png, "IHDR", header);
    if (!palette.empty()) append_chunk(png, "PLTE", palette);

    Bytes rows;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i % row_bytes == 0) rows.push_back(0);
        rows.push_back(samples[i]);
    }
    // One stored block of RFC 1951: no compression.
    const auto length = static_cast<std::uint16_t>(rows.size());
    const auto low = [](unsigned value) { return static_cast<std::uint8_t>(value & 0xffu); };
    Bytes zlib{0x78, 0x01, 0x01, low(length), low(length >> 8u), low(~length), low(~unsigned{length} >> 8u)};
    zlib.insert(zlib.end(), rows.begin(), rows.end());
    append_big_endian(zlib, adler32(rows), 4);
    append_chunk(png, "IDAT", zlib);
    append_chunk(png, "IEND", {});
    return png;
}

/// A baseline JPEG of 8 x 8 grey pixels of value 128: the one block has a zero DC difference and nothing
/// else, and each of the two Huffman tables has one code, "0".
inline Bytes make_grey_jpeg() {
    Bytes jpeg{0xff, 0xd8, 0xff, 0xdb, 0x00, 0x43, 0x00};
    jpeg.insert(jpeg.end(), 64, 1);
    const Bytes frame{0xff, 0xc0, 0x00, 0x0b, 8, 0, 8, 0, 8, 1, 1, 0x11, 0};
    jpeg.insert(jpeg.end(), frame.begin(), frame.end());
    for (const std::uint8_t table : {std::uint8_t{0x00}, std::uint8_t{0x10}}) {
        jpeg.insert(jpeg.end(), {0xff, 0xc4, 0x00, 0x14, table, 1});
        jpeg.insert(jpeg.end(), 15, 0);
        jpeg.push_back(0);
    }
    const Bytes scan{0xff, 0xda, 0x00, 0x08, 1, 1, 0x00, 0, 63, 0, 0x3f, 0xff, 0xd9};
    jpeg.insert(jpeg.end(), scan.begin(), scan.end());
    return jpeg;
}

inline std::vector<std::byte> as_bytes(const Bytes& bytes) {
    std::vector<std::byte> result;
    for (const std::uint8_t byte : bytes)
        result.push_back(std::byte{byte});
    return result;
}

}  // namespace utsuri::test
