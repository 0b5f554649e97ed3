// SPDX-License-Identifier: Apache-2.0
#include "import/document/source_file.h"

#include "base/error.h"

#include <fmt/format.h>

namespace utsuri {

void SourceFile::fail(std::string_view place, std::string_view problem) const {
    const std::string file = path.string();
    throw InputError(kImportOperation, place.empty() ? file : fmt::format("{}: {}", file, place), problem);
}

}  // namespace utsuri
