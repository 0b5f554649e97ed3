// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"
#include "import/conversion/materials.h"
#include "import/conversion/meshes.h"
#include "import/conversion/nodes.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <map>
#include <string>

namespace utsuri {

/// Places the mesh of a node, one instance for each primitive that has something to draw.
class InstanceImporter {
  public:
    explicit InstanceImporter(ImportContext& context)
        : context_(context), meshes_(context), materials_(context) {}

    /// @throws InputError if a primitive or material is wrong, or geometry lands beyond the range of float32.
    void import_node(const PlacedNode& placed);

  private:
    void place_primitive(const PlacedNode& placed, std::size_t mesh, std::size_t primitive);
    void check_extent(const Instance& instance, const std::string& place);
    glm::dvec3 farthest(std::uint32_t mesh);

    ImportContext& context_;
    MeshImporter meshes_;
    MaterialImporter materials_;
    std::map<std::uint32_t, glm::dvec3> farthest_;  ///< by mesh
};

}  // namespace utsuri
