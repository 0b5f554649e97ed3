// SPDX-License-Identifier: Apache-2.0
#include "scene/requirements.h"

#include "base/check.h"

#include "interop/shading.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace utsuri {
namespace {

constexpr std::size_t kRoughnessChannel = 1;
constexpr std::size_t kMetallicChannel = 2;
constexpr std::size_t kSpecularChannel = 3;

/// What a material does at its roughest, smoothest, most and least metallic points.
struct MaterialRange {
    RoughnessRange roughness;
    bool reflects = false;  ///< some point has a mirror or glossy lobe
    bool diffuse = false;   ///< some point has a diffuse lobe

    [[nodiscard]] bool may_be_mirror() const {
        return reflects && roughness.least < interop::SPECULAR_ROUGHNESS;
    }
    [[nodiscard]] bool may_be_glossy() const {
        return reflects && roughness.most >= interop::SPECULAR_ROUGHNESS;
    }
};

/// @param find_range the TextureRange of a texture by its index
template <typename FindRange>
MaterialRange material_range(const Material& material, const FindRange& find_range) {
    const auto factor = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
    const auto range_of = [&](const TextureSlot& slot) {
        return find_range(static_cast<std::size_t>(slot.texture));
    };
    MaterialRange result;
    result.roughness = {material.roughness, material.roughness};
    float most_metallic = material.metallic;
    float least_metallic = material.metallic;
    float most_specular = material.specular;
    if (material.metallic_roughness_texture.used()) {
        const TextureRange range = range_of(material.metallic_roughness_texture);
        result.roughness.least *= factor(range.least[kRoughnessChannel]);
        result.roughness.most *= factor(range.most[kRoughnessChannel]);
        most_metallic *= factor(range.most[kMetallicChannel]);
        least_metallic *= factor(range.least[kMetallicChannel]);
    }
    if (material.specular_texture.used())
        most_specular *= factor(range_of(material.specular_texture).most[kSpecularChannel]);
    result.reflects = most_metallic > 0.0f || most_specular > 0.0f;
    result.diffuse = least_metallic < 1.0f && material.base_colour != glm::vec3(0.0f);
    return result;
}

MaterialRange material_range(const Scene& scene, const Material& material) {
    return material_range(material,
                          [&](std::size_t texture) { return find_texture_range(scene.textures[texture]); });
}

std::vector<MaterialRange> material_ranges(const Scene& scene, TextureRanges& ranges) {
    UTSURI_CHECK_EQ(ranges.size(), scene.textures.size());
    std::vector<MaterialRange> result;
    result.reserve(scene.materials.size());
    for (const Material& material : scene.materials) {
        result.push_back(material_range(material, [&](std::size_t texture) {
            if (!ranges[texture]) ranges[texture] = find_texture_range(scene.textures[texture]);
            return *ranges[texture];
        }));
    }
    return result;
}

glm::dvec3 world_position(const Instance& instance, const glm::vec3& position) {
    return glm::dvec3(instance.world_from_object * glm::dvec4(glm::dvec3(position), 1.0));
}

/// Whether all vertices of instances, in world space, satisfy a condition; the first that does not ends the
/// search. They are transformed anew each time: keeping them would take more memory than the scene.
template <typename Condition>
bool all_vertices(const Scene& scene, const std::vector<std::uint32_t>& instances,
                  const Condition& condition) {
    for (const std::uint32_t index : instances) {
        const Instance& instance = scene.instances[index];
        for (const glm::vec3& position : scene.meshes[instance.mesh].positions) {
            if (!condition(world_position(instance, position))) return false;
        }
    }
    return true;
}

/// Whether all triangles of these instances lie in one plane, to a millionth of their size.
/// @param instances with triangles, at least one
bool in_one_plane(const Scene& scene, const std::vector<std::uint32_t>& instances) {
    constexpr double kRelativeTolerance = 1e-6;
    const Instance& first = scene.instances[instances.front()];
    const glm::dvec3 a = world_position(first, scene.meshes[first.mesh].positions.front());
    const auto farthest = [&](const auto& measure) {
        glm::dvec3 found = a;
        double most = measure(a);
        all_vertices(scene, instances, [&](const glm::dvec3& p) {
            const double here = measure(p);
            if (here > most) {
                most = here;
                found = p;
            }
            return true;
        });
        return found;
    };
    const glm::dvec3 b = farthest([&](const glm::dvec3& p) { return glm::length(p - a); });
    const double size = glm::length(b - a);
    if (size == 0.0) return true;
    const glm::dvec3 c = farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(p - a, b - a)); });
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (length == 0.0) return true;
    return all_vertices(scene, instances, [&](const glm::dvec3& p) {
        return std::abs(glm::dot(p - a, normal)) <= kRelativeTolerance * size * length;
    });
}

}  // namespace

TextureRange find_texture_range(const Texture& texture) {
    TextureRange range;
    for (std::size_t i = 0; i + 4 <= texture.rgba.size(); i += 4) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            range.least[channel] = std::min(range.least[channel], texture.rgba[i + channel]);
            range.most[channel] = std::max(range.most[channel], texture.rgba[i + channel]);
        }
    }
    return range;
}

bool may_be_mirror(const Scene& scene, const Material& material) {
    return material_range(scene, material).may_be_mirror();
}

bool may_be_glossy(const Scene& scene, const Material& material) {
    return material_range(scene, material).may_be_glossy();
}

Requirements find_requirements(const Scene& scene) {
    TextureRanges ranges(scene.textures.size());
    Requirements needs = find_requirements_but_depth(scene, ranges);
    needs.max_depth = find_max_depth(scene, needs);
    return needs;
}

std::uint32_t find_max_depth(const Scene& scene, const Requirements& needs) {
    std::vector<std::uint32_t> instances;
    std::set_union(needs.reflective_instances.begin(), needs.reflective_instances.end(),
                   needs.glossy_instances.begin(), needs.glossy_instances.end(),
                   std::back_inserter(instances));
    if (instances.empty()) return 0;
    return in_one_plane(scene, instances) ? 1 : kUnboundedDepth;
}

Requirements find_requirements_but_depth(const Scene& scene, TextureRanges& ranges) {
    const std::vector<MaterialRange> of_materials = material_ranges(scene, ranges);
    Requirements needs;
    std::set<std::uint32_t> materials;
    std::set<std::int32_t> textures;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[instance.material];
        const MaterialRange& range = of_materials[instance.material];
        needs.triangles += mesh.triangles.size();
        needs.vertices += mesh.positions.size();
        if (material.emissive != glm::vec3(0.0f)) needs.emissive_triangles += mesh.triangles.size();
        if (!mesh.triangles.empty() && range.may_be_mirror()) needs.reflective_instances.push_back(i);
        if (!mesh.triangles.empty() && range.may_be_glossy()) needs.glossy_instances.push_back(i);
        if (!materials.insert(instance.material).second) continue;
        for (const TextureSlot* slot : texture_slots(material)) {
            if (slot->used()) textures.insert(slot->texture);
        }
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        needs.surfaces.push_back({of_materials[i].may_be_glossy(), of_materials[i].may_be_mirror(),
                                  has_texture(scene.materials[i])});
        needs.roughness.push_back(of_materials[i].roughness);
        needs.diffuse.push_back(of_materials[i].diffuse);
    }
    for (const std::uint32_t material : materials)
        needs.glossy = needs.glossy || needs.surfaces[material].glossy;
    for (const std::int32_t texture : textures) {
        needs.texels += scene.textures[static_cast<std::size_t>(texture)].rgba.size() / 4;
    }
    needs.instances = static_cast<std::uint32_t>(scene.instances.size());
    needs.materials = static_cast<std::uint32_t>(materials.size());
    needs.textures = static_cast<std::uint32_t>(textures.size());
    needs.punctual_lights = static_cast<std::uint32_t>(scene.lights.size());
    needs.environment = scene.environment != glm::vec3(0.0f);
    needs.mirror = !needs.reflective_instances.empty();
    return needs;
}

}  // namespace utsuri
