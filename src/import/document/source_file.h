// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace utsuri {

constexpr std::string_view kImportOperation = "import glTF";

/// The file that every message names.
struct SourceFile {
    std::filesystem::path path;

    /// @throws InputError "import glTF FILE: PLACE: PROBLEM"; `place` is a JSON path, or empty for the file
    /// itself.
    [[noreturn]] void fail(std::string_view place, std::string_view problem) const;
};

}  // namespace utsuri
