// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/source_file.h"

#include <nlohmann/json_fwd.hpp>

namespace utsuri {

/// Checks the type, range and presence of every property that the importer or the glTF parser reads, and that
/// every index names an existing object. Integers written with a fraction of zero (3.0) become integers.
/// @throws InputError naming the JSON path and what would be right.
void check_schema(const SourceFile& file, nlohmann::json& root);

}  // namespace utsuri
