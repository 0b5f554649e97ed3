// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace utsuri {

/// Turns texture references of materials into slots, and images into textures of the scene, each decoded
/// once.
class TextureImporter {
  public:
    explicit TextureImporter(ImportContext& context) : context_(context) {}

    /// The slot for `info`, empty if there is none or it cannot be used (noted). `place` is the JSON path of
    /// `info`.
    /// @throws InputError if the image is missing or cannot be decoded.
    TextureSlot slot(const tinygltf::TextureInfo& info, const std::string& place);

  private:
    std::int32_t texture_of_image(std::size_t image);

    ImportContext& context_;
    std::map<std::size_t, std::int32_t> imported_;
};

}  // namespace utsuri
