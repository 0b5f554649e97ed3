// SPDX-License-Identifier: Apache-2.0
#include "compare/page/json_text.h"

#include <nlohmann/json.hpp>

namespace utsuri {

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string valid_utf8(const std::string& text) {
    return Json::parse(json_text(Json(text), -1)).get<std::string>();
}

}  // namespace utsuri
