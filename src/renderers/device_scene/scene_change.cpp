// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_change.h"

#include "renderers/device_scene/light_list.h"
#include "renderers/device_scene/material_list.h"
#include "renderers/device_scene/scene_buffers.h"
#include "renderers/device_scene/scene_constants.h"
#include "renderers/device_scene/scene_geometry.h"
#include "renderers/device_scene/texture_table.h"

#include "base/same_bits.h"

#include "interop/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace utsuri {
namespace {

/// Data before and after a change. Arrays that stayed were moved over: there are none of them before.
struct Step {
    const SceneData& before;
    const SceneData& after;
    GeometryChange geometry;
    TextureChange textures;

    /// Whether a buffer was moved over.
    [[nodiscard]] bool keeps(std::uint32_t binding) const {
        switch (binding) {
            case interop::BINDING_BVH_NODES:
            case interop::BINDING_BVH_TRIANGLES:
                return geometry == GeometryChange::none || geometry == GeometryChange::attributes;
            case interop::BINDING_NORMALS:
            case interop::BINDING_TEXCOORDS:
                return geometry == GeometryChange::none;
            default:
                return false;
        }
    }
};

std::string differing_counts(const Step& step) {
    const auto count = [](std::string_view thing, std::string_view things, std::size_t now,
                          std::size_t then) {
        if (now == then) return std::string();
        return fmt::format("it now has {} {} where it had {}", now, now == 1 ? thing : things, then);
    };
    const SceneData& before = step.before;
    const SceneData& after = step.after;
    const Requirements& a = before.requirements;
    const Requirements& b = after.requirements;
    for (const std::string& text :
         {count("triangle", "triangles", b.triangles, a.triangles),
          count("vertex", "vertices", b.vertices, a.vertices),
          count("instance", "instances", b.instances, a.instances),
          count("material", "materials", after.materials.size(), before.materials.size()),
          count("texture", "textures", after.texture_headers.size(), before.texture_headers.size()),
          count("light that shines", "lights that shine", after.lights.size(), before.lights.size())}) {
        if (!text.empty()) return text;
    }
    return {};
}

/// Of scenes with as many instances and materials.
bool has_other_triangles(const Step& step) {
    const auto same_triangle = [](const interop::TriangleInfo& x, const interop::TriangleInfo& y) {
        return x.vertices == y.vertices && x.material == y.material && x.instance == y.instance &&
               (x.light == interop::NONE) == (y.light == interop::NONE);
    };
    const auto& before = step.before.triangle_infos;
    const auto& after = step.after.triangle_infos;
    return step.geometry == GeometryChange::rebuilt ||
           !std::equal(before.begin(), before.end(), after.begin(), after.end(), same_triangle);
}

/// What kernels, buffers and maps were made for and the scene no longer is; empty if nothing.
std::string differing_requirement(const Step& step) {
    if (std::string text = differing_counts(step); !text.empty()) return text;
    const Requirements& a = step.before.requirements;
    const Requirements& b = step.after.requirements;
    if (b.environment != a.environment) return "its environment was switched on or off";
    if ((b.punctual_lights > 0) != (a.punctual_lights > 0))
        return "it now has punctual lights, or none any more";
    if ((b.emissive_triangles > 0) != (a.emissive_triangles > 0))
        return "it now has surfaces that shine, or none any more";
    if (step.textures.laid_out) return "its textures have other sizes";
    if (b.surfaces != a.surfaces)
        return "a material now needs other features: it became glossy, a mirror or neither";
    if (b.max_depth != a.max_depth) return "mirrors now face each other, or no longer do";
    if (has_other_triangles(step) || b.reflective_instances != a.reflective_instances)
        return "instances have other meshes or materials";
    if (scene_constants(step.after) != scene_constants(step.before)) return "it takes other kernels";
    return {};
}

/// Whether a triangle's vertices or their normals are elsewhere.
bool has_moved(const Step& step, std::uint32_t triangle) {
    if (step.geometry == GeometryChange::none) return false;
    if (!step.keeps(interop::BINDING_BVH_TRIANGLES) &&
        !same_bits(step.before.bvh.triangles[triangle], step.after.bvh.triangles[triangle]))
        return true;
    const glm::uvec3& vertices = step.after.triangle_infos[triangle].vertices;
    for (int corner = 0; corner < 3; ++corner) {
        if (step.before.normals[vertices[corner]] != step.after.normals[vertices[corner]]) return true;
    }
    return false;
}

/// Whether other parts of textures are on a triangle.
bool has_other_texcoords(const Step& step, std::uint32_t triangle) {
    if (step.geometry == GeometryChange::none) return false;
    const interop::TriangleInfo& info = step.after.triangle_infos[triangle];
    if (!step.after.requirements.surfaces[info.material].textured) return false;
    for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = info.vertices[corner];
        if (step.before.texcoords[vertex] != step.after.texcoords[vertex]) return true;
    }
    return false;
}

/// Of each material, whether what has it looks as before.
std::vector<bool> same_materials(const Step& step) {
    const auto same_texels = [&](const interop::TextureSlotInfo& slot) {
        return slot.texture == interop::NONE || !step.textures.textures[slot.texture];
    };
    std::vector<bool> same;
    for (std::size_t i = 0; i < step.after.materials.size(); ++i) {
        const interop::MaterialInfo& material = step.after.materials[i];
        same.push_back(
            same_bits(step.before.materials[i], material) && same_texels(material.base_colour_texture) &&
            same_texels(material.metallic_roughness_texture) && same_texels(material.emissive_texture) &&
            same_texels(material.specular_texture) && same_texels(material.specular_colour_texture));
    }
    return same;
}

/// Of a scene that is not rebuilt.
SceneChange find_changes(const Step& step) {
    const SceneData& before = step.before;
    const SceneData& after = step.after;
    SceneChange change;
    const std::vector<bool> same_material = same_materials(step);
    change.lights = before.requirements.diffuse != after.requirements.diffuse;
    const std::vector<interop::BvhTriangle>& were =
        step.keeps(interop::BINDING_BVH_TRIANGLES) ? after.bvh.triangles : before.bvh.triangles;
    for (std::uint32_t t = 0; t < after.triangle_infos.size(); ++t) {
        const bool moved = has_moved(step, t);
        const bool same_look =
            same_material[after.triangle_infos[t].material] && !has_other_texcoords(step, t);
        if (!moved && same_look) continue;
        change.triangles.push_back(t);
        change.before.push_back(were[t]);
        change.geometry |= moved;
        change.lights |= after.triangle_infos[t].light != interop::NONE;
    }
    change.lights |= !same_bits(before.lights, after.lights);
    const std::optional<std::uint32_t> then = before.environment_light();
    const std::optional<std::uint32_t> now = after.environment_light();
    change.environment = now && before.lights[*then].intensity != after.lights[*now].intensity;
    return change;
}

SceneChange rebuilt(std::string reason) {
    SceneChange change;
    change.geometry = true;
    change.lights = true;
    change.environment = true;
    change.rebuilt = true;
    change.reason = std::move(reason);
    return change;
}

/// Found again only where it can have changed: a colour is to cost no pass over vertices.
std::uint32_t follow_max_depth(const Requirements& before, const Scene& scene, GeometryChange geometry,
                               const Requirements& after) {
    const bool stays = geometry == GeometryChange::none &&
                       after.reflective_instances == before.reflective_instances &&
                       after.glossy_instances == before.glossy_instances;
    return stays ? before.max_depth : find_max_depth(scene, after);
}

std::vector<ChangedBytes> find_changed_bytes(const Step& step) {
    const auto before = scene_buffers(step.before);
    const auto after = scene_buffers(step.after);
    std::vector<ChangedBytes> changed(kSceneBuffers);
    for (std::size_t i = 0; i < kSceneBuffers; ++i) {
        if (step.keeps(after[i].binding)) continue;
        if (after[i].binding == interop::BINDING_TEXELS) {
            changed[i] = {step.textures.laid_out, step.textures.ranges};
        } else if (before[i].bytes.size() != after[i].bytes.size()) {
            changed[i].resized = true;
        } else {
            changed[i].ranges = differing_ranges(before[i].bytes, after[i].bytes);
        }
    }
    return changed;
}

}  // namespace

SceneChange update_scene_data(SceneData& data, const Scene& scene) {
    SceneData after;
    const TextureTable table(scene);
    // Texels are changed in place: a scene may have more of them than of all else.
    after.texels = std::move(data.texels);
    after.texture_headers = data.texture_headers;
    after.texture_facts = std::move(data.texture_facts);
    TextureChange textures = pack_textures(table, after);
    after.requirements = find_requirements_but_depth(scene, table, after.texture_facts);
    const GeometryChange geometry = follow_geometry(data, scene, after);
    after.requirements.max_depth = follow_max_depth(data.requirements, scene, geometry, after.requirements);
    after.materials = list_materials(scene, table);
    list_lights(scene, mean_emission(scene, table, after.texture_facts), after);

    const Step step{data, after, geometry, std::move(textures)};
    std::string reason = differing_requirement(step);
    SceneChange change = reason.empty() ? find_changes(step) : rebuilt(std::move(reason));
    const std::uint32_t light_steps = change.rebuilt ? 2 : change.geometry || change.lights ? 1 : 0;
    after.light_revision = data.light_revision + light_steps;
    after.revision = data.revision + 1;
    after.changed_bytes = find_changed_bytes(step);
    data = std::move(after);
    return change;
}

}  // namespace utsuri
