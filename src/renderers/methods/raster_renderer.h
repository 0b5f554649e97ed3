// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/surface_light.h"
#include "renderers/methods/prepared_maps.h"
#include "renderers/methods/renderer.h"
#include "renderers/methods/renderer_input.h"
#include "renderers/methods/view_drawer.h"
#include "renderers/reflection/raster/drawn_samples.h"

#include "image/image.h"

#include <memory>
#include <optional>

namespace utsuri {

/// How RasterRenderer shows mirrors.
struct RasterMethod {
    MapKind kind;  ///< of the maps that mirrors look up
    bool draws_mirrored_views =
        false;  ///< plane mirrors are drawn from mirrored eyes: PlanarView; else MappedView
};

/// Draws a scene by the raster pipeline, lit from the light kept on its surfaces, with what mirrors reflect
/// in maps, mirrored views and rays: all of that is made beforehand, or when a picture first needs it.
class RasterRenderer : public Renderer {
  public:
    RasterRenderer(const RendererInput& input, const RasterMethod& method, const RenderSettings& settings,
                   const MapSettings& map_settings);

    void prepare(Progress& progress) override;
    void update(const SceneChange& change, Progress& progress) override;
    /// A sphere map stays turned the way the first eye looked, until the scene changes.
    void set_camera(const Camera& camera) override;
    bool draw_frame() override;
    /// What draw_frame() drew.
    [[nodiscard]] Image frame() const;

    [[nodiscard]] std::vector<PredictedError> predict_errors() override;
    [[nodiscard]] std::vector<MeasuredError> measure_errors() override;
    /// Of MapKind::hybrid only.
    [[nodiscard]] std::vector<float> traced_pixels() override;

    /// prepare() comes first for both.
    [[nodiscard]] const PreparedMaps& maps() const { return *maps_; }
    [[nodiscard]] const ViewDrawer& view() const { return *view_; }

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    /// @param previous see PreparedMaps
    void make_view(PreparedMaps* previous);
    void warm_up();
    /// Captures the reflection maps that the present view looks up.
    void capture_first_view(Progress& progress);
    [[nodiscard]] bool tells_errors() const;
    [[nodiscard]] interop::FrameInfo frame_settings() const;
    /// Records one picture of the present view, with the rays that it leaves to follow.
    void record_picture(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame) const;

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    std::shared_ptr<SurfaceLight> light_;
    RasterMethod method_;
    RenderSettings settings_;
    MapSettings map_settings_;
    Camera camera_;
    std::unique_ptr<PreparedMaps> maps_;
    std::unique_ptr<ViewDrawer> view_;
    std::optional<DeferredTracer> deferred_;  ///< where reflections are left to rays
    std::optional<DrawnSamples> samples_;
};

}  // namespace utsuri
