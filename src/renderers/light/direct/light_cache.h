// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/device_counters.h"
#include "renderers/light/direct/light_reach.h"
#include "renderers/light/light_settings.h"
#include "renderers/light/surface_light.h"
#include "renderers/scene/gpu_scene.h"
#include "renderers/scene/scene_data.h"

#include "gpu/kernel.h"

#include "interop/light_cache.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// Direct light with shadows, kept at points in rows over each triangle, on both sides:
/// interop/light_cache.h.
class LightCache : public SurfaceLight {
  public:
    /// `device`, `data` and `scene` must outlive this, and may change: update().
    /// @throws DeviceError if it does not fit
    LightCache(Device& device, const SceneData& data, const GpuScene& scene, const LightSettings& settings);

    void fill(Progress& progress) override;
    /// Light is simulated only at points from which some way to a light leads through what changed.
    void update(const SceneChange& change, Progress& progress) override;

    [[nodiscard]] const std::vector<interop::LightCacheTriangle>& lattices() const { return lattices_; }
    /// What is kept, in the order of the lattices.
    [[nodiscard]] std::vector<interop::LightCachePoint> points() const;

  private:
    using Lattices = std::vector<interop::LightCacheTriangle>;
    using Points = std::vector<interop::LightCachePoint>;

    [[nodiscard]] Bindings kept_bindings() const override;
    [[nodiscard]] bool is_filled() const { return revision_ == scene_.light_revision(); }
    [[nodiscard]] Lattices plan() const;
    /// Whether what is kept is of the scene one change before, at the same points of surfaces that it did not
    /// touch.
    [[nodiscard]] bool may_keep(const Lattices& planned, const ChangedSpace& changed) const;
    void make_buffers(Lattices planned);
    void simulate(const std::vector<interop::ChangedBox>& changed, Progress& progress);
    FrameCounts simulate_points(const Kernel& kernel, const BindingSet& set,
                                const interop::LightCachePush& push);

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    LightSettings settings_;
    std::optional<std::uint32_t> revision_;  ///< GpuScene::light_revision() that the light is of
    Lattices lattices_;
    Buffer triangles_;
    Buffer light_;
    /// What is in light_, as the last update() read it; empty before the first one. The next update finds
    /// here what it compares with, and need not read it again.
    Points last_read_;
    DeviceCounters counters_;
};

}  // namespace utsuri
