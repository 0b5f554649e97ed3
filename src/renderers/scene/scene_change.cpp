// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/scene_change.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

namespace utsuri {
namespace {

/// Of records without padding.
template <typename Record>
bool same(const Record& a, const Record& b) {
    return std::memcmp(&a, &b, sizeof(Record)) == 0;
}

template <typename Record>
bool same(const std::vector<Record>& a, const std::vector<Record>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Record)) == 0);
}

/// What kernels, buffers and maps were made for and the scene no longer is; empty if nothing.
std::string differing_requirement(const SceneData& before, const SceneData& after) {
    const auto count = [](std::string_view things, std::size_t now, std::size_t then) {
        return now == then ? std::string()
                           : fmt::format("it now has {} {} where it had {}", now, things, then);
    };
    const Requirements& a = before.requirements;
    const Requirements& b = after.requirements;
    for (const std::string& text :
         {count("vertices", b.vertices, a.vertices), count("instances", b.instances, a.instances),
          count("materials", after.materials.size(), before.materials.size()),
          count("textures", after.texture_headers.size(), before.texture_headers.size()),
          count("texels", after.texels.size(), before.texels.size()),
          count("lights that shine", after.lights.size(), before.lights.size())}) {
        if (!text.empty()) return text;
    }
    if (b.environment != a.environment) return "its surroundings were switched on or off";
    if ((b.punctual_lights > 0) != (a.punctual_lights > 0))
        return "it now has punctual lights, or none any more";
    if ((b.emissive_triangles > 0) != (a.emissive_triangles > 0))
        return "it now has surfaces that shine, or none any more";
    if (!same(after.texture_headers, before.texture_headers)) return "its textures have other sizes";
    if (b.surfaces != a.surfaces)
        return "a material now needs other features: it became rough, a mirror or neither";
    if (b.max_depth != a.max_depth) return "mirrors now face each other, or no longer do";
    const auto same_triangle = [](const interop::TriangleInfo& x, const interop::TriangleInfo& y) {
        return x.vertices == y.vertices && x.material == y.material && x.instance == y.instance &&
               (x.light == interop::NONE) == (y.light == interop::NONE);
    };
    if (!std::equal(before.triangle_infos.begin(), before.triangle_infos.end(), after.triangle_infos.begin(),
                    after.triangle_infos.end(), same_triangle)) {
        return "instances have other meshes or materials";
    }
    return {};
}

/// Whether a triangle's vertices or their normals are elsewhere.
bool has_moved(const SceneData& before, const SceneData& after, std::uint32_t triangle) {
    if (!same(before.bvh.triangles[triangle], after.bvh.triangles[triangle])) return true;
    const glm::uvec3& vertices = before.triangle_infos[triangle].vertices;
    for (int corner = 0; corner < 3; ++corner) {
        if (before.normals[vertices[corner]] != after.normals[vertices[corner]]) return true;
    }
    return false;
}

/// Whether something with a texture may look otherwise.
bool uses_textures(const interop::MaterialInfo& material) {
    return material.base_colour_texture.texture != interop::NONE ||
           material.metallic_roughness_texture.texture != interop::NONE ||
           material.emissive_texture.texture != interop::NONE;
}

SceneChange find_changes(const SceneData& before, const SceneData& after) {
    SceneChange change;
    const bool same_texels = same(before.texels, after.texels);
    std::vector<bool> same_materials;
    for (std::size_t i = 0; i < after.materials.size(); ++i) {
        same_materials.push_back(same(before.materials[i], after.materials[i]) &&
                                 (same_texels || !uses_textures(after.materials[i])));
        change.lights |= reflects_diffusely(before.materials[i]) != reflects_diffusely(after.materials[i]);
    }
    for (std::uint32_t t = 0; t < after.triangle_infos.size(); ++t) {
        const bool moved = has_moved(before, after, t);
        if (!moved && same_materials[after.triangle_infos[t].material]) continue;
        change.triangles.push_back(t);
        change.before.push_back(before.bvh.triangles[t]);
        change.geometry |= moved;
        change.lights |= after.triangle_infos[t].light != interop::NONE;
    }
    change.lights |= !same(before.lights, after.lights) || !same(before.light_table, after.light_table);
    const std::optional<std::uint32_t> then = before.environment_light();
    const std::optional<std::uint32_t> now = after.environment_light();
    change.surroundings = now && before.lights[*then].intensity != after.lights[*now].intensity;
    return change;
}

}  // namespace

SceneChange update_scene_data(SceneData& data, const Scene& scene) {
    SceneData after = prepare_changed_scene(data, scene);
    if (const std::string difference = differing_requirement(data, after); !difference.empty())
        throw InputError("follow a scene", scene.name, difference + "; prepare it anew");
    const SceneChange change = find_changes(data, after);
    after.light_revision = data.light_revision + (change.geometry || change.lights ? 1 : 0);
    data = std::move(after);
    return change;
}

}  // namespace utsuri
