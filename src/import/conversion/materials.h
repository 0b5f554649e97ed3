// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"
#include "import/conversion/textures.h"

#include <cstdint>
#include <map>
#include <string>

namespace utsuri {

/// Turns materials into materials of the scene, each at its first use.
class MaterialImporter {
  public:
    explicit MaterialImporter(ImportContext& context) : context_(context), textures_(context) {}

    /// The scene's material for `material`, an index into the file's materials, or glTF's default material
    /// for -1.
    /// @throws InputError if a texture cannot be read or a value is out of its range.
    std::uint32_t material_of(int material);

  private:
    Material read(std::size_t index);
    void read_specular(const nlohmann::json& specular, Material& material, const std::string& place);
    void leave_out_black_emission(Material& material, const std::string& place);

    ImportContext& context_;
    TextureImporter textures_;
    std::map<int, std::uint32_t> imported_;
};

}  // namespace utsuri
