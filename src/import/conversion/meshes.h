// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace utsuri {

/// Turns primitives into meshes of the scene, each at its first use.
class MeshImporter {
  public:
    explicit MeshImporter(ImportContext& context) : context_(context) {}

    /// The scene's mesh for a primitive, or nothing if it has no triangle to draw.
    /// @throws InputError naming the attribute or index that is wrong.
    std::optional<std::uint32_t> mesh_of(std::size_t mesh, std::size_t primitive);

    /// A mesh of its own for an instance whose transform is singular, or nothing if no area is left.
    std::optional<std::uint32_t> flattened_mesh(std::uint32_t mesh, const glm::dmat4& world_from_object,
                                                const std::string& place);

  private:
    std::optional<std::uint32_t> add(Mesh mesh);

    ImportContext& context_;
    std::map<std::pair<std::size_t, std::size_t>, std::optional<std::uint32_t>> imported_;
};

}  // namespace utsuri
