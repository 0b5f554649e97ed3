// SPDX-License-Identifier: Apache-2.0
#include "compare/page/html_page.h"

#include "compare/page/json_text.h"

#include "base/check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string coded;
    coded.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            group = group << 8 | (j < count ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0u);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            coded += j <= count ? kDigits[group >> (18 - 6 * j) & 63u] : '=';
        }
    }
    return coded;
}

std::string replace_each(std::string_view source,
                         std::span<const std::pair<char, std::string_view>> replacements) {
    std::string result;
    result.reserve(source.size());
    for (const char c : source) {
        const auto found = std::find_if(replacements.begin(), replacements.end(),
                                        [c](const auto& replacement) { return replacement.first == c; });
        if (found == replacements.end()) {
            result += c;
        } else {
            result += found->second;
        }
    }
    return result;
}

}  // namespace

std::string data_uri(std::string_view media_type, std::span<const std::byte> bytes) {
    return fmt::format("data:{};base64,{}", media_type, base64(bytes));
}

std::string script_safe(const Json& json) {
    // JSON has these characters only inside strings, where they may be written as escapes.
    constexpr std::array<std::pair<char, std::string_view>, 3> kEscapes = {
        {{'<', "\\u003c"}, {'>', "\\u003e"}, {'&', "\\u0026"}}};
    return replace_each(json_text(json, -1), kEscapes);
}

std::string html_text(std::string_view source) {
    constexpr std::array<std::pair<char, std::string_view>, 5> kEntities = {
        {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};
    return replace_each(source, kEntities);
}

std::string fill_template(std::string_view page, std::span<const Part> parts) {
    std::string filled;
    for (const Part& part : parts) {
        const std::size_t at = page.find(part.marker);
        UTSURI_CHECK_LT(at, page.size());
        filled += page.substr(0, at);
        filled += part.value;
        page.remove_prefix(at + part.marker.size());
    }
    filled += page;
    return filled;
}

}  // namespace utsuri
