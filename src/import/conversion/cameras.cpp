// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/cameras.h"

#include "scene/default_view.h"

#include <glm/geometric.hpp>

#include <numbers>
#include <string>

namespace utsuri {
namespace {

/// Sets the axes to those of the node without scale and shear; the view direction is kept exactly.
/// @returns false if the transform leaves no view direction or no up.
bool set_axes(const glm::dmat4& world_from_node, Camera& camera) {
    const glm::dvec3 back = glm::normalize(glm::dvec3(world_from_node[2]));
    const glm::dvec3 up = glm::normalize(glm::dvec3(world_from_node[1]));
    const glm::dvec3 right = glm::cross(up, back);
    constexpr double kParallel = 1e-12;  // sine of the angle below which rounding decides the roll
    if (!(glm::length(right) > kParallel)) return false;
    camera.forward = -back;
    camera.right = glm::normalize(right);
    camera.up = glm::cross(back, camera.right);
    return true;
}

}  // namespace

void import_camera(ImportContext& context, const PlacedNode& placed) {
    const Document& document = context.document;
    const tinygltf::Node& node = document.model.nodes[placed.node];
    if (node.camera < 0) return;
    const std::string place = fmt::format("cameras[{}]", node.camera);
    const tinygltf::Camera& source = document.model.cameras[static_cast<std::size_t>(node.camera)];
    if (source.type != "perspective") {
        context.ignored.add("orthographic cameras are not used", place);
        return;
    }
    if (source.perspective.yfov >= std::numbers::pi) {
        document.fail(place + ".perspective.yfov",
                      fmt::format("is {}; must be less than pi, in radians", source.perspective.yfov));
    }
    Camera camera;
    camera.name = !source.name.empty() ? source.name : (!node.name.empty() ? node.name : place);
    camera.vertical_fov = source.perspective.yfov;
    camera.position = glm::dvec3(placed.world_from_node[3]);
    if (!set_axes(placed.world_from_node, camera)) {
        context.ignored.add("cameras whose node has no direction left are not used",
                            fmt::format("nodes[{}]", placed.node));
        return;
    }
    context.result.scene.cameras.push_back(camera);
    context.near_planes.push_back(source.perspective.znear);
}

void add_default_camera(ImportContext& context) {
    Scene& scene = context.result.scene;
    if (!scene.cameras.empty()) return;
    scene.cameras.push_back(frame_scene(scene));
    context.result.added.emplace_back(
        "no camera in the file: one that frames the whole scene, named \"default\"");
}

}  // namespace utsuri
