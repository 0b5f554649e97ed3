// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/changed_bytes.h"

#include "geometry/bvh.h"
#include "scene/requirements.h"
#include "scene/scene.h"
#include "scene/world_geometry.h"

#include "interop/light_tree.h"
#include "interop/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// Where a texture is among the texels.
struct TextureHeader {
    std::uint32_t first_texel;
    std::uint32_t width;
    std::uint32_t height;
};

/// What is known of a packed texture, found when first asked for.
struct TextureFacts {
    std::optional<TextureRange> range;
    std::optional<double> mean;  ///< of its colour channels, decoded: mean_colour()
};

/// What triangles are made from, kept to tell without making them whether they would be the same again.
struct GeometrySource {
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
};

/// Which triangles each instance has, and where they are.
struct InstanceTriangles {
    std::vector<std::uint32_t> triangles;  ///< those of the first instance, ascending, then of the next one
    std::vector<std::uint32_t> first;      ///< where those of each instance begin; at last, where all end
    std::vector<Bounds> bounds;            ///< of each instance; scene space
};

/// A scene in the form the device reads, still on the host. Only what the scene requires is filled.
struct SceneData {
    Requirements requirements;
    glm::dvec3 origin{0.0};  ///< of scene space, in world space
    Bounds bounds;           ///< scene space
    Bvh bvh;
    std::vector<interop::TriangleInfo> triangle_infos;  ///< device order
    InstanceTriangles instance_triangles;               ///< of the host alone; triangles_of(), bounds_of()
    float layer_distance = 0.0f;  ///< layer_distance() where surfaces overlap in one plane, else 0; metres
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords;  ///< only with textures
    std::vector<interop::MaterialInfo> materials;
    std::vector<interop::LightInfo> lights;  ///< environment, directional, other punctual ones, triangles
    std::vector<interop::LightTreeNode> light_tree;
    std::vector<TextureHeader> texture_headers;  ///< only textures in use; of the host alone
    std::vector<std::uint32_t> texels;           ///< RGBA8, red in the lowest byte
    double build_seconds = 0.0;                  ///< of the BVH, or of what its last change took
    /// Changes of what light falls on surfaces since the scene was prepared; one that SceneChange::rebuilt
    /// counts twice, so that light kept from before it is never taken for light of one change before.
    std::uint32_t light_revision = 0;

    // For update_scene_data() and GpuScene::update().
    std::vector<TextureFacts> texture_facts;  ///< of each header
    GeometrySource geometry_source;
    std::uint32_t revision = 0;               ///< calls of update_scene_data() since the scene was prepared
    std::vector<ChangedBytes> changed_bytes;  ///< of each of scene_buffers(), by the last such call

    /// Index of the environment among the lights; none if they are black.
    [[nodiscard]] std::optional<std::uint32_t> environment_light() const;
    /// How many lights are nowhere: the environment and directional ones.
    [[nodiscard]] std::uint32_t infinite_lights() const;
    /// What the scene takes on the device, in bytes.
    [[nodiscard]] std::uint64_t device_bytes() const;
};

/// Transforms the scene's geometry, builds its BVH, and lists its lights weighted by their power.
/// @param scene valid: check_scene()
SceneData prepare_scene_data(const Scene& scene);

}  // namespace utsuri
