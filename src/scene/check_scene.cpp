// SPDX-License-Identifier: Apache-2.0
#include "scene/check_scene.h"

#include "base/error.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

namespace utsuri {
namespace {

constexpr const char* kOperation = "use scene";
/// A last row this far from (0, 0, 0, 1) is rounding, and is taken as exact.
constexpr double kAffineTolerance = 1e-6;
/// By how much squares of lengths and products of unit vectors may be off: what is given with three decimals
/// passes.
constexpr double kUnitTolerance = 2e-3;
/// By how much half a turn rounded to float32 may exceed itself.
constexpr double kAngleRounding = 1e-6;

/// An element of one of the scene's lists. Its name is only put together where something is wrong.
struct Element {
    std::string_view list;
    std::size_t index;

    [[noreturn]] void fail(std::string_view value, std::string_view problem) const {
        throw InputError(kOperation, fmt::format("{}[{}].{}", list, index, value), problem);
    }
};

template <glm::length_t length, typename Number, glm::qualifier qualifier>
bool is_finite(const glm::vec<length, Number, qualifier>& vector) {
    for (glm::length_t i = 0; i < length; ++i) {
        if (!std::isfinite(vector[i])) return false;
    }
    return true;
}

/// Zero or more, and a number; infinity is one.
bool is_intensity(const glm::vec3& value) {
    return value.x >= 0.0f && value.y >= 0.0f && value.z >= 0.0f;
}

std::string text_of(const glm::vec3& value) {
    return fmt::format("({:g}, {:g}, {:g})", value.x, value.y, value.z);
}

/// Fails unless all of a list of a mesh are good.
template <typename Vector, typename Check>
void check_all(const std::vector<Vector>& list, std::string_view name, const Element& mesh, Check is_good,
               std::string_view problem) {
    const auto bad = std::find_if_not(list.begin(), list.end(), is_good);
    if (bad != list.end()) mesh.fail(fmt::format("{}[{}]", name, bad - list.begin()), problem);
}

void check_length(std::size_t length, std::size_t positions, std::string_view name, const Element& mesh) {
    if (length == positions) return;
    mesh.fail(name, fmt::format("has {} entries; must have one for each position, {}", length, positions));
}

void check_triangles(const Mesh& mesh, const Element& place) {
    const std::size_t count = mesh.positions.size();
    const auto bad = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [count](const glm::uvec3& t) {
        return t.x >= count || t.y >= count || t.z >= count;
    });
    if (bad == mesh.triangles.end()) return;
    place.fail(fmt::format("triangles[{}]", bad - mesh.triangles.begin()),
               fmt::format("joins positions {}, {} and {}; must be below their number, {}", bad->x, bad->y,
                           bad->z, count));
}

void check_mesh(const Mesh& mesh, const Element& place) {
    const std::size_t count = mesh.positions.size();
    check_length(mesh.normals.size(), count, "normals", place);
    if (!mesh.texcoords.empty()) check_length(mesh.texcoords.size(), count, "texcoords", place);
    check_all(
        mesh.positions, "positions", place, [](const glm::vec3& position) { return is_finite(position); },
        "is not finite; must be");
    check_all(
        mesh.normals, "normals", place,
        [](const glm::vec3& normal) { return is_finite(normal) && normal != glm::vec3(0.0f); },
        "is zero or not finite; must be a unit vector");
    check_all(
        mesh.texcoords, "texcoords", place, [](const glm::vec2& texcoord) { return is_finite(texcoord); },
        "is not finite; must be");
    check_triangles(mesh, place);
}

/// The largest distance of a vertex from the origin of the mesh along each axis.
glm::dvec3 reach_of(const Mesh& mesh) {
    glm::vec3 reach(0.0f);
    for (const glm::vec3& position : mesh.positions)
        reach = glm::max(reach, glm::abs(position));
    return glm::dvec3(reach);
}

/// @param things in the plural
void check_index(std::size_t index, std::size_t count, std::string_view things, std::string_view value,
                 const Element& place) {
    if (index < count) return;
    place.fail(value, fmt::format("is {}; must be below the number of {}, {}", index, things, count));
}

void check_transform(const glm::dmat4& transform, const glm::dvec3& reach, const Element& instance) {
    for (int column = 0; column < 4; ++column) {
        if (!is_finite(transform[column])) instance.fail("world_from_object", "is not finite; must be");
        const double last = column == 3 ? 1.0 : 0.0;
        if (std::abs(transform[column][3] - last) > kAffineTolerance)
            instance.fail("world_from_object",
                          fmt::format("has {:g} in the last row of column {}; must be {:g}, as in every "
                                      "affine matrix",
                                      transform[column][3], column, last));
    }
    for (int row = 0; row < 3; ++row) {
        const double extent = std::abs(transform[0][row]) * reach.x + std::abs(transform[1][row]) * reach.y +
                              std::abs(transform[2][row]) * reach.z + std::abs(transform[3][row]);
        if (extent <= static_cast<double>(std::numeric_limits<float>::max())) continue;
        instance.fail("world_from_object",
                      fmt::format("places its mesh up to {:.3g} m away; must be within the range of float32, "
                                  "3.4e38 m",
                                  extent));
    }
}

void check_instances(const Scene& scene) {
    std::vector<glm::dvec3> reaches;
    reaches.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes)
        reaches.push_back(reach_of(mesh));
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Element place{"instances", i};
        check_index(instance.mesh, scene.meshes.size(), "meshes", "mesh", place);
        check_index(instance.material, scene.materials.size(), "materials", "material", place);
        check_transform(instance.world_from_object, reaches[instance.mesh], place);
        vertices += scene.meshes[instance.mesh].positions.size();
        triangles += scene.meshes[instance.mesh].triangles.size();
    }
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (vertices <= kMost && triangles <= kMost) return;
    throw InputError(kOperation, "instances",
                     fmt::format("have {} vertices and {} triangles together; must have at most {} of each",
                                 vertices, triangles, kMost));
}

void check_share(float share, std::string_view value, const Element& place) {
    if (!(share >= 0.0f && share <= 1.0f))
        place.fail(value, fmt::format("is {:g}; must be in [0, 1]", share));
}

void check_material(const Material& material, std::size_t textures, const Element& place) {
    for (int c = 0; c < 3; ++c)
        check_share(material.base_colour[c], "base_colour", place);
    check_share(material.metallic, "metallic", place);
    check_share(material.roughness, "roughness", place);
    check_share(material.specular, "specular", place);
    if (!is_intensity(material.specular_colour))
        place.fail("specular_colour",
                   fmt::format("is {}; must be at least 0 each", text_of(material.specular_colour)));
    if (!is_intensity(material.emissive))
        place.fail("emissive",
                   fmt::format("is {} cd/m2; must be at least 0 each", text_of(material.emissive)));
    if (!(material.ior >= 1.0f) || !std::isfinite(material.ior))
        place.fail("ior", fmt::format("is {:g}; must be finite, and at least 1", material.ior));
    const auto check_slot = [&](const TextureSlot& slot, std::string_view value) {
        if (slot.used())
            check_index(static_cast<std::size_t>(slot.texture), textures, "textures", value, place);
    };
    check_slot(material.base_colour_texture, "base_colour_texture.texture");
    check_slot(material.metallic_roughness_texture, "metallic_roughness_texture.texture");
    check_slot(material.emissive_texture, "emissive_texture.texture");
    check_slot(material.specular_texture, "specular_texture.texture");
    check_slot(material.specular_colour_texture, "specular_colour_texture.texture");
}

void check_texture(const Texture& texture, const Element& place) {
    if (texture.width < 1) place.fail("width", "is 0; must be at least 1");
    if (texture.height < 1) place.fail("height", "is 0; must be at least 1");
    // Divided, because four times the product may exceed 64 bits.
    const std::size_t bytes = texture.rgba.size();
    const std::size_t row_bytes = std::size_t{4} * texture.width;
    if (bytes % row_bytes == 0 && bytes / row_bytes == texture.height) return;
    place.fail("rgba", fmt::format("has {} bytes; must have 4 for each of {} x {} texels", bytes,
                                   texture.width, texture.height));
}

void check_cone(const Light& light, const Element& place) {
    const double outer = light.outer_cone_angle;
    if (!(outer > 0.0 && outer <= 0.5 * std::numbers::pi + kAngleRounding))
        place.fail("outer_cone_angle",
                   fmt::format("is {:g}; must be above 0 and at most pi/2, in radians", outer));
    if (!(light.inner_cone_angle >= 0.0 && light.inner_cone_angle <= outer))
        place.fail("inner_cone_angle",
                   fmt::format("is {:g}; must be at least 0 and at most outer_cone_angle, {:g}, in radians",
                               light.inner_cone_angle, outer));
}

void check_light(const Light& light, const Element& place) {
    if (!is_intensity(light.intensity))
        place.fail("intensity", fmt::format("is {}; must be at least 0 each", text_of(light.intensity)));
    if (!(light.range >= 0.0))
        place.fail("range", fmt::format("is {:g} m; must be at least 0, which means unlimited", light.range));
    if (light.type != LightType::directional && !is_finite(light.position))
        place.fail("position", "is not finite; must be");
    if (light.type != LightType::point &&
        !(std::abs(glm::dot(light.direction, light.direction) - 1.0) <= kUnitTolerance))
        place.fail("direction",
                   fmt::format("has length {:g}; must be a unit vector", glm::length(light.direction)));
    if (light.type == LightType::spot) check_cone(light, place);
}

}  // namespace

std::optional<ValueFault> find_fault(const Camera& camera) {
    if (!is_finite(camera.position)) return ValueFault{"position", "is not finite; must be"};
    if (!(camera.vertical_fov > 0.0 && camera.vertical_fov < std::numbers::pi)) {
        return ValueFault{"vertical_fov", fmt::format("is {:g}; must be above 0 and below pi, in radians",
                                                      camera.vertical_fov)};
    }
    const glm::dmat3 axes(camera.right, camera.up, camera.forward);
    constexpr std::array kNames = {"right", "up", "forward"};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            const double expected = i == j ? 1.0 : 0.0;
            if (std::abs(glm::dot(axes[i], axes[j]) - expected) <= kUnitTolerance) continue;
            return ValueFault{kNames[static_cast<std::size_t>(i)],
                              "must be a unit vector at right angles to the other axes"};
        }
    }
    return std::nullopt;
}

void check_scene(const Scene& scene) {
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        check_mesh(scene.meshes[i], {"meshes", i});
    check_instances(scene);
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        check_material(scene.materials[i], scene.textures.size(), {"materials", i});
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        check_texture(scene.textures[i], {"textures", i});
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        check_light(scene.lights[i], {"lights", i});
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        if (const auto fault = find_fault(scene.cameras[i]))
            Element{"cameras", i}.fail(fault->name, fault->problem);
    }
    if (!is_intensity(scene.environment)) {
        throw InputError(kOperation, "environment",
                         fmt::format("is {} cd/m2; must be at least 0 each", text_of(scene.environment)));
    }
}

}  // namespace utsuri
