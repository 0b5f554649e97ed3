// SPDX-License-Identifier: Apache-2.0
#include "import/document/uri.h"

#include "base/error.h"
#include "base/file.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <span>

namespace utsuri {
namespace {

constexpr std::string_view kDataScheme = "data:";
constexpr std::string_view kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 255;

constexpr std::array<std::uint8_t, 256> base64_values() {
    std::array<std::uint8_t, 256> values{};
    for (std::uint8_t& value : values)
        value = kNoDigit;
    for (std::size_t i = 0; i < kBase64Digits.size(); ++i) {
        values[static_cast<unsigned char>(kBase64Digits[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}

/// RFC 4648, section 4; the padding may be missing.
std::vector<std::byte> base64_decode(const SourceFile& file, std::string_view text, std::string_view place) {
    static constexpr std::array<std::uint8_t, 256> kValues = base64_values();
    const std::size_t length = text.size();
    for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding)
        text.remove_suffix(1);
    if (text.size() % 4 == 1) {
        file.fail(place,
                  fmt::format("truncated base64 data: {} characters; must be a multiple of 4", length));
    }
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint8_t value = kValues[static_cast<unsigned char>(text[i])];
        if (value == kNoDigit) {
            file.fail(
                place,
                fmt::format("character {} of the base64 data is 0x{:02x}; must be one of A-Z a-z 0-9 + /", i,
                            static_cast<unsigned char>(text[i])));
        }
        bits = (bits << 6) | value;
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes.push_back(static_cast<std::byte>((bits >> held) & 0xFFu));
        }
    }
    return bytes;
}

std::vector<std::byte> decode_data_uri(const SourceFile& file, std::string_view uri, std::string_view place) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        file.fail(place, "data: URI without a comma; must be data:[type][;base64],DATA");
    const std::string_view header = uri.substr(0, comma);
    const std::string_view data = uri.substr(comma + 1);
    if (header.ends_with(";base64")) return base64_decode(file, data, place);
    const std::string text = percent_decode(data);
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

int hex_value(char digit) {
    if (digit >= '0' && digit <= '9') return digit - '0';
    if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
    if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
    return -1;
}

}  // namespace

std::string percent_decode(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape = text[i] == '%' && i + 2 < text.size();
        const int high = escape ? hex_value(text[i + 1]) : -1;
        const int low = escape ? hex_value(text[i + 2]) : -1;
        if (high >= 0 && low >= 0) {
            decoded.push_back(static_cast<char>(high * 16 + low));
            i += 2;
        } else {
            decoded.push_back(text[i]);
        }
    }
    return decoded;
}

std::vector<std::byte> read_uri(const SourceFile& file, std::string_view uri, std::string_view place) {
    if (uri.starts_with(kDataScheme)) return decode_data_uri(file, uri, place);
    if (uri.find("://") != std::string_view::npos) {
        file.fail(
            place,
            fmt::format("\"{}\" is not beside the glTF file; must be a relative path or a data: URI", uri));
    }
    const std::string name = percent_decode(uri);
    if (name.empty() || name.find('\0') != std::string::npos) {
        file.fail(place, "names no file; must be a relative path or a data: URI");
    }
    const std::u8string utf8(name.begin(), name.end());
    try {
        return read_file(file.path.parent_path() / std::filesystem::path(utf8), kImportOperation);
    } catch (const InputError& error) {
        file.fail(place,
                  fmt::format("\"{}\" cannot be read ({}); must be a readable file", name, error.what()));
    }
}

}  // namespace utsuri
