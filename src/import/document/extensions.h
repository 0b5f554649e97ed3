// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/notes.h"
#include "import/document/source_file.h"

#include <nlohmann/json_fwd.hpp>

namespace utsuri {

/// @throws InputError naming the first required extension that the importer does not have, and those it has.
void check_required_extensions(const SourceFile& file, const nlohmann::json& root);

/// Notes every extension that is declared or present but not used, with what that changes in the picture.
void note_unused_extensions(const nlohmann::json& root, FeatureNotes& ignored);

}  // namespace utsuri
