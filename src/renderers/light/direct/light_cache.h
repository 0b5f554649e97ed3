// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/scene_data.h"
#include "renderers/light/direct/light_reach.h"
#include "renderers/light/light_settings.h"
#include "renderers/light/mesh/light_mesh.h"
#include "renderers/light/mesh/light_mesher.h"
#include "renderers/light/surface_light.h"

#include "interop/light_mesh.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// @param buffer_bytes that the device has room for in one buffer
MeshSettings mesh_settings(const SceneData& data, const LightSettings& settings, std::uint64_t buffer_bytes);

/// Direct light with shadows, kept on a mesh over each triangle, on both sides: interop/light_mesh.h.
class LightCache : public SurfaceLight {
  public:
    /// `device`, `data` and `scene` must outlive this, and may change: update().
    LightCache(Device& device, const SceneData& data, const GpuScene& scene, const LightSettings& settings);

    void fill(Progress& progress) override;
    /// Light is simulated only at points that are new, or from which some way to a light leads through what
    /// changed.
    void update(const SceneChange& change, Progress& progress) override;

    /// What is kept.
    [[nodiscard]] const LightMesh& mesh() const { return mesh_; }

  private:
    /// Light at places, those included that the mesh turned out not to need.
    struct Told {
        std::vector<interop::LightMeshPlace> places;
        std::vector<interop::LightMeshPoint> light;
    };

    [[nodiscard]] Bindings kept_bindings() const override;
    [[nodiscard]] bool is_filled() const { return revision_ == scene_.light_revision(); }
    /// @param known right but for what changed
    void simulate(const Told& known, const ChangedSpace& changed, Progress& progress);
    void keep(LightMesh mesh);

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    LightSettings settings_;
    std::optional<std::uint32_t> revision_;  ///< GpuScene::light_revision() that the light is of
    LightMesh mesh_;
    Told told_;
    Buffer nodes_;
    Buffer sides_;
};

}  // namespace utsuri
