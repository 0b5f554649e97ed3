// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/gltf.h"
#include "import/document/buffers.h"
#include "import/document/document.h"
#include "import/document/notes.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// What the parts of the importer share: where they read and where they write.
struct ImportContext {
    const Document& document;
    Buffers buffers;
    FeatureNotes ignored;
    FeatureNotes added;
    ImportResult result;
    std::vector<double> near_planes;  ///< of the scene's cameras, metres

    explicit ImportContext(const Document& source) : document(source), buffers(source) {}
};

/// "1 triangle", "2 triangles".
inline std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace utsuri
