// SPDX-License-Identifier: Apache-2.0
#include "scene/requirements.h"

#include "interop/shading.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>
#include <set>

namespace utsuri {
namespace {

struct Range {
    float lower = 1.0f;
    float upper = 1.0f;
};

/// Smallest and largest value of a channel over a texture; [1, 1] without one.
Range channel_range(const Scene& scene, const TextureSlot& slot, std::size_t channel) {
    if (!slot.used()) return {};
    const Texture& texture = scene.textures[static_cast<std::size_t>(slot.texture)];
    std::uint8_t lower = 255;
    std::uint8_t upper = 0;
    for (std::size_t i = channel; i < texture.rgba.size(); i += 4) {
        lower = std::min(lower, texture.rgba[i]);
        upper = std::max(upper, texture.rgba[i]);
    }
    return {static_cast<float>(lower) / 255.0f, static_cast<float>(upper) / 255.0f};
}

constexpr std::size_t kRoughnessChannel = 1;
constexpr std::size_t kMetallicChannel = 2;

bool reflects(const Scene& scene, const Material& material) {
    const Range metallic = channel_range(scene, material.metallic_roughness_texture, kMetallicChannel);
    return material.metallic * metallic.upper > 0.0f || material.specular > 0.0f;
}

RoughnessRange roughness_range(const Scene& scene, const Material& material) {
    const Range texture = channel_range(scene, material.metallic_roughness_texture, kRoughnessChannel);
    return {material.roughness * texture.lower, material.roughness * texture.upper};
}

bool has_texture(const Material& material) {
    return material.base_colour_texture.used() || material.metallic_roughness_texture.used() ||
           material.emissive_texture.used();
}

/// Whether all triangles of these instances lie in one plane, to a millionth of their size.
bool in_one_plane(const Scene& scene, const std::vector<std::uint32_t>& instances) {
    constexpr double kRelativeTolerance = 1e-6;
    std::vector<glm::dvec3> points;
    for (const std::uint32_t index : instances) {
        const Instance& instance = scene.instances[index];
        for (const glm::vec3& position : scene.meshes[instance.mesh].positions) {
            points.emplace_back(instance.world_from_object * glm::dvec4(glm::dvec3(position), 1.0));
        }
    }
    const auto farthest = [&](const auto& measure) {
        return *std::max_element(points.begin(), points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
            return measure(a) < measure(b);
        });
    };
    const glm::dvec3 a = points.front();
    const glm::dvec3 b = farthest([&](const glm::dvec3& p) { return glm::length(p - a); });
    const double size = glm::length(b - a);
    if (size == 0.0) return true;
    const glm::dvec3 c = farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(p - a, b - a)); });
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (length == 0.0) return true;
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& p) {
        return std::abs(glm::dot(p - a, normal)) <= kRelativeTolerance * size * length;
    });
}

}  // namespace

bool may_be_specular(const Scene& scene, const Material& material) {
    return reflects(scene, material) && roughness_range(scene, material).least < interop::SPECULAR_ROUGHNESS;
}

bool may_be_glossy(const Scene& scene, const Material& material) {
    return reflects(scene, material) && roughness_range(scene, material).most >= interop::SPECULAR_ROUGHNESS;
}

Requirements find_requirements(const Scene& scene) {
    Requirements needs;
    std::vector<std::uint32_t> lobed_instances;
    std::set<std::uint32_t> materials;
    std::set<std::int32_t> textures;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[instance.material];
        needs.triangles += mesh.triangles.size();
        needs.vertices += mesh.positions.size();
        if (material.emissive != glm::vec3(0.0f)) needs.emissive_triangles += mesh.triangles.size();
        if (!mesh.triangles.empty() && may_be_specular(scene, material))
            needs.reflective_instances.push_back(i);
        if (!mesh.triangles.empty() && reflects(scene, material)) lobed_instances.push_back(i);
        if (!materials.insert(instance.material).second || !has_texture(material)) continue;
        for (const TextureSlot* slot : {&material.base_colour_texture, &material.metallic_roughness_texture,
                                        &material.emissive_texture}) {
            if (slot->used()) textures.insert(slot->texture);
        }
    }
    for (const Material& material : scene.materials) {
        needs.surfaces.push_back(
            {may_be_glossy(scene, material), may_be_specular(scene, material), has_texture(material)});
        needs.roughness.push_back(roughness_range(scene, material));
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
    needs.specular = !needs.reflective_instances.empty();
    if (!lobed_instances.empty()) {
        needs.max_depth = in_one_plane(scene, lobed_instances) ? 1 : kUnboundedDepth;
    }
    return needs;
}

}  // namespace utsuri
