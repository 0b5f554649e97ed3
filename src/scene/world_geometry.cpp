// SPDX-License-Identifier: Apache-2.0
#include "scene/world_geometry.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <limits>

namespace utsuri {
namespace {

glm::dvec3 transform_point(const glm::dmat4& matrix, const glm::vec3& point) {
    return glm::dvec3(matrix * glm::dvec4(glm::dvec3(point), 1.0));
}

glm::dvec3 centre_of_scene(const Scene& scene) {
    glm::dvec3 lower(std::numeric_limits<double>::infinity());
    glm::dvec3 upper(-lower);
    for (const Instance& instance : scene.instances) {
        for (const glm::vec3& position : scene.meshes[instance.mesh].positions) {
            const glm::dvec3 world = transform_point(instance.world_from_object, position);
            lower = glm::min(lower, world);
            upper = glm::max(upper, world);
        }
    }
    return lower.x <= upper.x ? 0.5 * (lower + upper) : glm::dvec3(0.0);
}

/// The cofactor matrix: it takes normals along under any affine map, singular ones too, up to length and, for
/// mirroring maps, sign.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

glm::vec3 transform_normal(const glm::dmat3& matrix, double side, const glm::vec3& normal) {
    const glm::dvec3 world = side * (matrix * glm::dvec3(normal));
    const double length = glm::length(world);
    return length > 0.0 ? glm::vec3(world / length) : normal;
}

void append_instance(const Scene& scene, std::uint32_t index, WorldGeometry& world) {
    const Instance& instance = scene.instances[index];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dmat3 linear(instance.world_from_object);
    const bool mirrors = glm::determinant(linear) < 0.0;
    const glm::dmat3 normals_matrix = normal_matrix(linear);
    const auto first = static_cast<std::uint32_t>(world.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 position =
            transform_point(instance.world_from_object, mesh.positions[i]) - world.origin;
        world.positions.emplace_back(position);
        world.normals.push_back(transform_normal(normals_matrix, mirrors ? -1.0 : 1.0, mesh.normals[i]));
        world.texcoords.push_back(mesh.texcoords.empty() ? glm::vec2(0.0f) : mesh.texcoords[i]);
        world.bounds.extend(world.positions.back());
    }
    for (const glm::uvec3& triangle : mesh.triangles) {
        // Mirroring turns the winding round; glTF keeps the front in front (specification, section 3.7.4).
        const glm::uvec3 wound = mirrors ? glm::uvec3(triangle.x, triangle.z, triangle.y) : triangle;
        world.triangles.push_back(wound + first);
        world.instances.push_back(index);
    }
}

}  // namespace

WorldGeometry make_world_geometry(const Scene& scene) {
    return make_world_geometry(scene, centre_of_scene(scene));
}

WorldGeometry make_world_geometry(const Scene& scene, const glm::dvec3& origin) {
    WorldGeometry world;
    world.origin = origin;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
        append_instance(scene, i, world);
    return world;
}

}  // namespace utsuri
