// SPDX-License-Identifier: Apache-2.0
#include "scene/default_view.h"

#include "scene/world_geometry.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace utsuri {

Camera frame_scene(const Scene& scene) {
    Camera camera;
    camera.name = "default";
    camera.vertical_fov = glm::radians(45.0);
    const WorldGeometry world = make_world_geometry(scene);
    if (world.bounds.empty()) return camera;

    // The sphere around the scene's box just fits the narrower of the two fields of view of a square picture.
    const double radius = 0.5 * glm::length(glm::dvec3(world.bounds.extent()));
    const double distance = radius > 0.0 ? radius / std::sin(0.5 * camera.vertical_fov) : 1.0;
    camera.forward = -glm::normalize(glm::dvec3(1.0, 0.7, 1.0));
    camera.right = glm::normalize(glm::cross(camera.forward, glm::dvec3(0.0, 1.0, 0.0)));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.position = world.origin - distance * camera.forward;
    return camera;
}

}  // namespace utsuri
