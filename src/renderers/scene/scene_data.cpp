// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/scene_data.h"

#include "renderers/scene/light_table.h"

#include "base/error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

namespace utsuri {
namespace {

constexpr double kPi = std::numbers::pi;

double rec709_luminance(const glm::vec3& c) {
    return 0.2126 * static_cast<double>(c.x) + 0.7152 * static_cast<double>(c.y) +
           0.0722 * static_cast<double>(c.z);
}

/// Gives each texture in use its place in the texel buffer.
class TextureTable {
  public:
    TextureTable(const Scene& scene, SceneData& data) : scene_(scene), data_(data) {}

    interop::TextureSlotInfo slot(const TextureSlot& slot) {
        if (!slot.used()) return {interop::NONE, 0};
        const auto [found, added] =
            indices_.try_emplace(slot.texture, static_cast<std::uint32_t>(data_.texture_headers.size()));
        if (added) append(scene_.textures[static_cast<std::size_t>(slot.texture)]);
        return {found->second, static_cast<std::uint32_t>(slot.wrap_s) |
                                   (static_cast<std::uint32_t>(slot.wrap_t) << 2) |
                                   (static_cast<std::uint32_t>(slot.filter) << 4)};
    }

  private:
    void append(const Texture& texture) {
        data_.texture_headers.push_back(
            {static_cast<std::uint32_t>(data_.texels.size()), texture.width, texture.height});
        for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
            data_.texels.push_back(
                std::uint32_t{texture.rgba[i]} | (std::uint32_t{texture.rgba[i + 1]} << 8) |
                (std::uint32_t{texture.rgba[i + 2]} << 16) | (std::uint32_t{texture.rgba[i + 3]} << 24));
        }
    }

    const Scene& scene_;
    SceneData& data_;
    std::map<std::int32_t, std::uint32_t> indices_;
};

void add_materials(const Scene& scene, SceneData& data) {
    TextureTable textures(scene, data);
    for (const Material& material : scene.materials) {
        const float ratio = (material.ior - 1.0f) / (material.ior + 1.0f);
        interop::MaterialInfo info{};
        info.base_colour = material.base_colour;
        info.metallic = material.metallic;
        info.emissive = material.emissive;
        info.roughness = material.roughness;
        info.dielectric_f0 = ratio * ratio * material.specular;
        info.dielectric_f90 = material.specular;
        info.ior = material.ior;
        info.double_sided = material.double_sided ? 1 : 0;
        info.base_colour_texture = textures.slot(material.base_colour_texture);
        info.metallic_roughness_texture = textures.slot(material.metallic_roughness_texture);
        info.emissive_texture = textures.slot(material.emissive_texture);
        data.materials.push_back(info);
    }
}

/// Mean over the texels of the emissive texture, which scales the power of the triangles that use it.
glm::vec3 mean_emission(const Scene& scene, const Material& material) {
    if (!material.emissive_texture.used()) return material.emissive;
    const Texture& texture = scene.textures[static_cast<std::size_t>(material.emissive_texture.texture)];
    double sum = 0.0;
    for (std::size_t i = 0; i < texture.rgba.size(); ++i) {
        if (i % 4 != 3) sum += std::pow(static_cast<double>(texture.rgba[i]) / 255.0, 2.2);
    }
    // Never zero: a light that can shine must be able to be chosen, however dark its texture's mean.
    const double mean = std::max(sum / (0.75 * static_cast<double>(texture.rgba.size())), 1.0 / 255.0);
    return material.emissive * static_cast<float>(mean);
}

double triangle_area(const interop::BvhTriangle& triangle) {
    const glm::dvec3 v0(triangle.v0);
    return 0.5 * glm::length(glm::cross(glm::dvec3(triangle.v1) - v0, glm::dvec3(triangle.v2) - v0));
}

/// Collects lights with their power in lumens over 4 pi, which is what they are chosen by.
class LightList {
  public:
    explicit LightList(SceneData& data) : data_(data) {
        radius_ = 0.5 * glm::length(glm::dvec3(data.bounds.empty() ? glm::vec3(0.0f) : data.bounds.extent()));
    }

    void add(const interop::LightInfo& info, double power) {
        if (!(power > 0.0)) return;
        data_.lights.push_back(info);
        weights_.push_back(power);
    }

    void add_environment(const glm::vec3& radiance) {
        interop::LightInfo info{};
        info.type = interop::LIGHT_ENVIRONMENT;
        info.triangle = interop::NONE;
        info.intensity = radiance;
        // An empty scene has no size; the environment is still its light.
        const double disc = radius_ > 0.0 ? kPi * radius_ * radius_ : 1.0;
        add(info, kPi * disc * rec709_luminance(radiance));
    }

    void add_punctual(const Light& light, const glm::dvec3& origin) {
        interop::LightInfo info{};
        info.triangle = interop::NONE;
        info.position = glm::vec3(light.position - origin);
        info.direction = glm::vec3(light.direction);
        info.intensity = light.intensity;
        info.range =
            light.range > 0.0 ? static_cast<float>(light.range) : std::numeric_limits<float>::infinity();
        const double cos_outer = std::cos(light.outer_cone_angle);
        const double scale = 1.0 / std::max(0.001, std::cos(light.inner_cone_angle) - cos_outer);
        info.spot_scale = static_cast<float>(scale);
        info.spot_offset = static_cast<float>(-cos_outer * scale);
        const double intensity = rec709_luminance(light.intensity);
        switch (light.type) {
            case LightType::point:
                info.type = interop::LIGHT_POINT;
                return add(info, 4.0 * kPi * intensity);
            case LightType::spot:
                info.type = interop::LIGHT_SPOT;
                return add(info, 2.0 * kPi * (1.0 - cos_outer) * intensity);
            case LightType::directional:
                info.type = interop::LIGHT_DIRECTIONAL;
                return add(info, kPi * radius_ * radius_ * intensity);
        }
    }

    void add_triangle(std::uint32_t triangle, const glm::vec3& radiance, bool double_sided) {
        interop::LightInfo info{};
        info.type = interop::LIGHT_TRIANGLE;
        info.triangle = triangle;
        const double area = triangle_area(data_.bvh.triangles[triangle]);
        const std::size_t before = data_.lights.size();
        add(info, kPi * area * rec709_luminance(radiance) * (double_sided ? 2.0 : 1.0));
        if (data_.lights.size() > before)
            data_.triangle_infos[triangle].light = static_cast<std::uint32_t>(before);
    }

    void finish() { data_.light_table = make_light_table(weights_, data_.lights); }

  private:
    SceneData& data_;
    double radius_ = 0.0;
    std::vector<double> weights_;
};

void add_triangles(const Scene& scene, const WorldGeometry& world, SceneData& data) {
    data.triangle_infos.reserve(data.bvh.order.size());
    for (const std::uint32_t input : data.bvh.order) {
        const std::uint32_t instance = world.instances[input];
        data.triangle_infos.push_back(
            {world.triangles[input], scene.instances[instance].material, instance, interop::NONE});
    }
}

void add_lights(const Scene& scene, SceneData& data) {
    LightList lights(data);
    if (data.requirements.environment) lights.add_environment(scene.environment);
    for (const Light& light : scene.lights)
        lights.add_punctual(light, data.origin);
    std::vector<glm::vec3> emission;
    for (const Material& material : scene.materials)
        emission.push_back(mean_emission(scene, material));
    for (std::uint32_t i = 0; i < data.triangle_infos.size(); ++i) {
        const std::uint32_t material = data.triangle_infos[i].material;
        if (emission[material] == glm::vec3(0.0f)) continue;
        lights.add_triangle(i, emission[material], scene.materials[material].double_sided);
    }
    lights.finish();
}

/// All but the BVH, which is there.
void describe(const Scene& scene, WorldGeometry world, SceneData& data) {
    data.requirements = find_requirements(scene);
    data.origin = world.origin;
    data.bounds = world.bounds;
    add_triangles(scene, world, data);
    add_materials(scene, data);
    add_lights(scene, data);
    data.normals = std::move(world.normals);
    if (data.requirements.textures > 0) data.texcoords = std::move(world.texcoords);
}

}  // namespace

bool reflects_diffusely(const interop::MaterialInfo& material) {
    return material.metallic < 1.0f && material.base_colour != glm::vec3(0.0f);
}

SceneData prepare_scene_data(const Scene& scene) {
    SceneData data;
    WorldGeometry world = make_world_geometry(scene);
    const auto start = std::chrono::steady_clock::now();
    data.bvh = build_bvh(world.positions, world.triangles);
    data.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    describe(scene, std::move(world), data);
    return data;
}

SceneData prepare_changed_scene(const SceneData& before, const Scene& scene) {
    SceneData data;
    WorldGeometry world = make_world_geometry(scene, before.origin);
    if (world.triangles.size() != before.bvh.order.size()) {
        throw InputError("follow a scene", scene.name,
                         fmt::format("it now has {} triangles where it had {}; prepare it anew",
                                     world.triangles.size(), before.bvh.order.size()));
    }
    data.bvh = before.bvh;
    const auto start = std::chrono::steady_clock::now();
    refit(data.bvh, world.positions, world.triangles);
    data.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    describe(scene, std::move(world), data);
    return data;
}

std::optional<std::uint32_t> SceneData::environment_light() const {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (lights[i].type == interop::LIGHT_ENVIRONMENT) return i;
    }
    return std::nullopt;
}

std::uint64_t SceneData::device_bytes() const {
    const auto bytes = [](const auto& records) { return records.size() * sizeof(records[0]); };
    return bytes(bvh.nodes) + bytes(bvh.triangles) + bytes(triangle_infos) + bytes(normals) +
           bytes(texcoords) + bytes(materials) + bytes(lights) + bytes(light_table) + bytes(texture_headers) +
           bytes(texels);
}

}  // namespace utsuri
