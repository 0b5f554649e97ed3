// SPDX-License-Identifier: Apache-2.0
#include "support/coded_room.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace utsuri::test {
namespace {

/// One wall, its front inside. Texture coordinates put its corners at the centres of the four texels.
Mesh wall_mesh(const glm::dvec3& lower, const glm::dvec3& upper, int axis, bool far) {
    glm::vec3 corner(lower);
    glm::vec3 u(0.0f);
    glm::vec3 v(0.0f);
    const glm::vec3 size(upper - lower);
    u[(axis + 1) % 3] = size[(axis + 1) % 3];
    v[(axis + 2) % 3] = size[(axis + 2) % 3];
    if (far) {
        corner[axis] = static_cast<float>(upper[axis]);
        std::swap(u, v);
    }
    Mesh mesh = quad(corner, u, v);
    mesh.texcoords = {{0.25f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.75f}, {0.25f, 0.75f}};
    return mesh;
}

/// The four corners in the order of texels: row by row.
Texture wall_texture(const Mesh& wall, const glm::dvec3& lower, const glm::dvec3& upper) {
    Texture texture;
    texture.width = 2;
    texture.height = 2;
    const glm::vec3 middle(0.5 * (lower + upper));
    for (const std::size_t corner : {0u, 1u, 3u, 2u}) {
        for (int channel = 0; channel < 3; ++channel) {
            texture.rgba.push_back(wall.positions[corner][channel] > middle[channel] ? 255 : 0);
        }
        texture.rgba.push_back(255);
    }
    return texture;
}

}  // namespace

void CodedRoom::add_to(Scene& scene, unsigned left_out) const {
    for (int wall = 0; wall < 6; ++wall) {
        if ((left_out >> wall & 1u) != 0) continue;
        Mesh mesh = wall_mesh(lower_, upper_, wall / 2, wall % 2 == 1);
        scene.textures.push_back(wall_texture(mesh, lower_, upper_));
        Material material = emitter(glm::vec3(1.0f));
        material.emissive_texture.texture = static_cast<std::int32_t>(scene.textures.size() - 1);
        material.emissive_texture.wrap_s = TextureWrap::clamp_to_edge;
        material.emissive_texture.wrap_t = TextureWrap::clamp_to_edge;
        add(scene, std::move(mesh), material);
    }
}

glm::dvec3 CodedRoom::wall_point(const glm::dvec3& origin, const glm::dvec3& direction) const {
    double t = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) continue;
        const double wall = direction[axis] > 0.0 ? upper_[axis] : lower_[axis];
        t = std::min(t, (wall - origin[axis]) / direction[axis]);
    }
    return origin + t * direction;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace utsuri::test
