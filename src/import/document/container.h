// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/source_file.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace utsuri {

/// The two parts of a glTF file. The views point into `bytes`, which survives a move but not a copy.
struct Container {
    std::vector<std::byte> bytes;
    std::string_view json;
    std::span<const std::byte> bin;  ///< BIN chunk; empty for .gltf

    Container() = default;
    Container(const Container&) = delete;
    Container& operator=(const Container&) = delete;
    Container(Container&&) = default;
    Container& operator=(Container&&) = default;
    ~Container() = default;
};

/// Reads the file and splits a .glb into its chunks (glTF 2.0 specification, section 4).
/// @throws InputError if the file cannot be read, is empty, or is a damaged .glb.
Container read_container(const SourceFile& file);

}  // namespace utsuri
