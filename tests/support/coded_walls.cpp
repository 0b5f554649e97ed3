// SPDX-License-Identifier: Apache-2.0
#include "support/coded_walls.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace utsuri::test {
namespace {

/// Red grows along u, green along v: the four corners of a wall in the order of texels, row by row.
Texture wall_texture() {
    Texture texture;
    texture.width = 2;
    texture.height = 2;
    texture.rgba = {0, 0, 255, 255, 255, 0, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255};
    return texture;
}

}  // namespace

void CodedWalls::add_wall(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    walls_.push_back({corner, u, v});
}

void CodedWalls::add_to(Scene& scene, unsigned left_out) const {
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        if ((left_out >> i & 1u) != 0) continue;
        const Wall& wall = walls_[i];
        // Corners are rounded once, so that walls that meet there share their bits.
        Mesh mesh = quad(glm::vec3(wall.corner), glm::vec3(wall.u), glm::vec3(wall.v));
        mesh.positions = {glm::vec3(wall.corner), glm::vec3(wall.corner + wall.u),
                          glm::vec3(wall.corner + wall.u + wall.v), glm::vec3(wall.corner + wall.v)};
        // Corners at the centres of the four texels.
        mesh.texcoords = {{0.25f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.75f}, {0.25f, 0.75f}};
        scene.textures.push_back(wall_texture());
        Material material = emitter(glm::vec3(1.0f, 1.0f, static_cast<float>(i + 1)));
        material.emissive_texture.texture = static_cast<std::int32_t>(scene.textures.size() - 1);
        material.emissive_texture.wrap_s = TextureWrap::clamp_to_edge;
        material.emissive_texture.wrap_t = TextureWrap::clamp_to_edge;
        add(scene, std::move(mesh), material);
    }
}

glm::dvec3 CodedWalls::decode(const glm::dvec3& radiance) const {
    const double number = std::round(radiance.z);
    EXPECT_NEAR(radiance.z, number, 0.01) << "of several walls";
    if (!(number >= 1.0 && number <= static_cast<double>(walls_.size()))) {
        ADD_FAILURE() << "of no wall: " << radiance.z;
        return glm::dvec3(std::numeric_limits<double>::infinity());
    }
    const Wall& wall = walls_[static_cast<std::size_t>(number) - 1];
    return wall.corner + radiance.x * wall.u + radiance.y * wall.v;
}

glm::dvec3 CodedWalls::wall_point(const glm::dvec3& origin, const glm::dvec3& direction) const {
    double t = std::numeric_limits<double>::infinity();
    for (const HalfSpace& plane : planes()) {
        const double towards = glm::dot(plane.normal, direction);
        if (towards > 0.0) t = std::min(t, (plane.offset - glm::dot(plane.normal, origin)) / towards);
    }
    return origin + t * direction;
}

std::vector<HalfSpace> CodedWalls::planes() const {
    std::vector<HalfSpace> planes;
    for (const Wall& wall : walls_) {
        const glm::dvec3 outward = -glm::normalize(glm::cross(wall.u, wall.v));
        planes.push_back({outward, glm::dot(outward, wall.corner)});
    }
    return planes;
}

glm::dvec3 turned(const glm::dvec3& point, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * point.x + s * point.z, point.y, c * point.z - s * point.x};
}

CodedWalls turned_room(const glm::dvec3& lower, const glm::dvec3& upper, double angle) {
    CodedWalls walls;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool far : {false, true}) {
            glm::dvec3 corner = lower;
            glm::dvec3 u(0.0);
            glm::dvec3 v(0.0);
            u[(axis + 1) % 3] = upper[(axis + 1) % 3] - lower[(axis + 1) % 3];
            v[(axis + 2) % 3] = upper[(axis + 2) % 3] - lower[(axis + 2) % 3];
            if (far) {
                corner[axis] = upper[axis];
                std::swap(u, v);
            }
            walls.add_wall(turned(corner, angle), turned(u, angle), turned(v, angle));
        }
    }
    return walls;
}

CodedWalls hexagonal_room(const glm::dvec3& centre, double apothem, double height, double angle) {
    CodedWalls walls;
    const glm::dvec3 up(0.0, height, 0.0);
    const double half_side = apothem * std::tan(std::numbers::pi / 6.0);
    for (int side = 0; side < 6; ++side) {
        const double direction = angle + side * std::numbers::pi / 3.0;
        const glm::dvec3 outward(std::cos(direction), 0.0, std::sin(direction));
        const glm::dvec3 along(-outward.z, 0.0, outward.x);
        walls.add_wall(glm::dvec3(centre.x, 0.0, centre.z) + apothem * outward - half_side * along,
                       2.0 * half_side * along, up);
    }
    const double reach = 1.2 * apothem;
    const glm::dvec3 x(2.0 * reach, 0.0, 0.0);
    const glm::dvec3 z(0.0, 0.0, 2.0 * reach);
    const glm::dvec3 corner(centre.x - reach, 0.0, centre.z - reach);
    walls.add_wall(corner, z, x);
    walls.add_wall(corner + up, x, z);
    return walls;
}

}  // namespace utsuri::test
