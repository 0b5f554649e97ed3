// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/container.h"
#include "import/document/source_file.h"

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <filesystem>
#include <string_view>

namespace utsuri {

/// A glTF file whose structure is checked: every index exists, every number is in its range, every bufferView
/// lies in its buffer and every accessor in its bufferViews. Contents of buffers and images are not read yet.
struct Document {
    SourceFile file;
    Container container;
    nlohmann::json json;    ///< the whole file
    tinygltf::Model model;  ///< typed form, without buffers, images, skins and animations

    [[noreturn]] void fail(std::string_view place, std::string_view problem) const {
        file.fail(place, problem);
    }
};

/// @throws InputError if the file cannot be read or its structure is wrong.
Document load_document(const std::filesystem::path& path);

/// The extension object `name` of `parent`, or an empty object.
const nlohmann::json& extension_of(const nlohmann::json& parent, const char* name);

}  // namespace utsuri
