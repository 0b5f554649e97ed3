// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/source_file.h"

#include <nlohmann/json_fwd.hpp>

namespace utsuri {

/// Checks by arithmetic alone, before anything is read or allocated, that every bufferView lies in its buffer
/// and every accessor in its bufferViews. `root` has passed check_schema.
/// @throws InputError naming the JSON path, the size needed and the size there is.
void check_layout(const SourceFile& file, const nlohmann::json& root);

/// The bytes of one element of an accessor, tightly packed, from its componentType and type.
struct ElementLayout {
    std::size_t component_size = 0;
    std::size_t components = 0;
    [[nodiscard]] std::size_t size() const { return component_size * components; }
};
ElementLayout element_layout(int component_type, std::string_view type);

}  // namespace utsuri
