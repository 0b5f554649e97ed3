// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/instances.h"

#include "import/conversion/normals.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace utsuri {

void InstanceImporter::import_node(const PlacedNode& placed) {
    const tinygltf::Node& node = context_.document.model.nodes[placed.node];
    if (node.mesh < 0) return;
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (node.skin >= 0) {
        context_.ignored.add("skins are not applied, meshes are drawn unposed",
                             fmt::format("nodes[{}]", placed.node));
    }
    const std::size_t count = context_.document.model.meshes[mesh].primitives.size();
    for (std::size_t primitive = 0; primitive < count; ++primitive)
        place_primitive(placed, mesh, primitive);
}

void InstanceImporter::place_primitive(const PlacedNode& placed, std::size_t mesh, std::size_t primitive) {
    const Document& document = context_.document;
    const tinygltf::Node& node = document.model.nodes[placed.node];
    const auto& primitives = document.model.meshes[mesh].primitives;
    const std::string place = fmt::format("nodes[{}]", placed.node);
    auto scene_mesh = meshes_.mesh_of(mesh, primitive);
    if (!scene_mesh) return;
    Instance instance;
    instance.world_from_object = placed.world_from_node;
    if (is_singular(glm::dmat3(placed.world_from_node))) {
        scene_mesh = meshes_.flattened_mesh(*scene_mesh, placed.world_from_node, place);
        if (!scene_mesh) return;
        instance.world_from_object = glm::dmat4(1.0);
        instance.world_from_object[3] = placed.world_from_node[3];
    }
    instance.mesh = *scene_mesh;
    Scene& scene = context_.result.scene;
    instance.name = node.name.empty() ? scene.meshes[instance.mesh].name : node.name;
    if (!node.name.empty() && primitives.size() > 1) instance.name += fmt::format("[{}]", primitive);
    instance.material = materials_.material_of(primitives[primitive].material);
    check_extent(instance, place);
    if (has_texture(scene.materials[instance.material]) && scene.meshes[instance.mesh].texcoords.empty()) {
        context_.ignored.add("textures on meshes without TEXCOORD_0 are looked up at (0, 0)", place);
    }
    scene.instances.push_back(std::move(instance));
}

/// The largest distance of a vertex from the origin of the mesh along each axis.
glm::dvec3 InstanceImporter::farthest(std::uint32_t mesh) {
    const auto [entry, is_new] = farthest_.try_emplace(mesh, 0.0);
    if (!is_new) return entry->second;
    for (const glm::vec3 position : context_.result.scene.meshes[mesh].positions) {
        entry->second = glm::max(entry->second, glm::abs(glm::dvec3(position)));
    }
    return entry->second;
}

void InstanceImporter::check_extent(const Instance& instance, const std::string& place) {
    const glm::dmat4& transform = instance.world_from_object;
    const glm::dvec3 reach = farthest(instance.mesh);
    for (int row = 0; row < 3; ++row) {
        const double extent = std::abs(transform[0][row]) * reach.x + std::abs(transform[1][row]) * reach.y +
                              std::abs(transform[2][row]) * reach.z + std::abs(transform[3][row]);
        if (extent <= static_cast<double>(std::numeric_limits<float>::max())) continue;
        context_.document.fail(place,
                               fmt::format("places its mesh up to {:.3g} m away; must be within the range of "
                                           "float32, 3.4e38 m",
                                           extent));
    }
}

}  // namespace utsuri
