// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace utsuri {

/// What the pages that reports are have in common: they are filled templates and hold all that they show.

/// "data:" and the bytes in base 64.
/// @param media_type for example "image/png"
std::string data_uri(std::string_view media_type, std::span<const std::byte> bytes);

/// JSON for a script element: no string in it can end that element. What is not UTF-8 becomes U+FFFD.
std::string script_safe(const nlohmann::ordered_json& json);

/// Text with the characters that HTML gives a meaning written as entities.
std::string html_text(std::string_view text);

/// A place in a template and what goes there.
struct Part {
    std::string_view marker;
    std::string_view value;
};

/// The template with each marker, in this order and once each, replaced by its value. Values are not
/// searched.
/// @pre every marker is there
std::string fill_template(std::string_view page, std::span<const Part> parts);

/// A file of page_files.h.
template <std::size_t N>
std::string_view file_text(const char (&bytes)[N]) {
    return {bytes, N};
}

}  // namespace utsuri
