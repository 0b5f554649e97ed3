// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bvh.h"
#include "scene/requirements.h"
#include "scene/scene.h"
#include "scene/world_geometry.h"

#include "interop/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// A scene in the form the device reads, still on the host. Only what the scene requires is filled.
struct SceneData {
    Requirements requirements;
    glm::dvec3 origin{0.0};  ///< of scene space, in world space
    Bounds bounds;           ///< scene space
    Bvh bvh;
    std::vector<interop::TriangleInfo> triangle_infos;  ///< device order
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords;  ///< only with textures
    std::vector<interop::MaterialInfo> materials;
    std::vector<interop::LightInfo> lights;  ///< punctual ones before those with extent
    std::vector<interop::LightTableEntry> light_table;
    std::vector<interop::TextureHeader> texture_headers;  ///< only textures in use
    std::vector<std::uint32_t> texels;                    ///< RGBA8, red in the lowest byte
    double build_seconds = 0.0;                           ///< of the BVH
    /// Changes of what light falls on surfaces since the scene was prepared: update_scene_data().
    std::uint32_t light_revision = 0;

    /// Index of the uniform surroundings among the lights; none if they are black.
    [[nodiscard]] std::optional<std::uint32_t> environment_light() const;
    /// What the scene takes on the device, in bytes.
    [[nodiscard]] std::uint64_t device_bytes() const;
};

/// Whether some of the light that arrives at surfaces of a material is reflected diffusely.
bool reflects_diffusely(const interop::MaterialInfo& material);

/// Transforms the scene's geometry, builds its BVH, and lists its lights weighted by their power.
SceneData prepare_scene_data(const Scene& scene);

/// The same of a scene in which things have moved or shine otherwise: triangles keep their numbers, so that
/// what is kept about them can be told from what is not; the BVH is refitted.
/// @throws InputError if there are not as many triangles as before
SceneData prepare_changed_scene(const SceneData& before, const Scene& scene);

}  // namespace utsuri
