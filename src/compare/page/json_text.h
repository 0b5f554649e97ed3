// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace utsuri {

/// JSON as text. Bytes in its strings that are not UTF-8 become U+FFFD, as JSON can hold no others: the path
/// of a scene may have some.
/// @param indent spaces of a level; -1 puts all of it on one line
std::string json_text(const nlohmann::ordered_json& json, int indent);

/// Bytes that are not UTF-8 replaced by U+FFFD.
std::string valid_utf8(const std::string& text);

}  // namespace utsuri
