// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/prepared_maps.h"
#include "renderers/methods/renderer.h"
#include "renderers/reflection/planar/planar_drawer.h"
#include "renderers/reflection/raster/prediction_drawer.h"

#include <memory>
#include <optional>
#include <vector>

namespace utsuri {

/// Plane mirrors drawn with mirrored cameras, to a depth; what is reflective but not plane looks maps up.
/// Everything is lit from light kept on surfaces. With MapKind::hybrid, rays are followed where maps are not
/// right enough, and where the image in a mirror would cost more than they do.
class PlanarRenderer : public Renderer {
  public:
    /// `device`, `data`, `scene` and `light` must outlive this.
    /// @param light is filled by the first renderer that needs it; its cost counts for each
    /// @param kind of the maps: proxy, or hybrid with a tolerance of place
    PlanarRenderer(Device& device, const SceneData& data, const GpuScene& scene, SurfaceLight& light,
                   const Camera& camera, MapKind kind, const RenderSettings& settings,
                   const MapSettings& map_settings);

    void prepare(Progress& progress) override;
    void update(const SceneChange& change, Progress& progress) override;
    void set_camera(const Camera& camera) override;
    bool draw_frame() override;

    /// Of MapKind::hybrid only. Plane mirrors show what rays would, and nothing off its place; what their
    /// images do not show could be off by anything, were it not traced.
    [[nodiscard]] std::vector<PredictedError> predict_errors() override;
    [[nodiscard]] std::vector<MeasuredError> measure_errors() override;
    [[nodiscard]] std::vector<float> traced_pixels() override;

    [[nodiscard]] const PlaneMirrors& mirrors() const { return mirrors_; }
    /// What a frame draws.
    [[nodiscard]] const std::vector<MirrorImage>& images() const { return images_; }

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    /// @param former see PreparedMaps
    void make_drawers(PreparedMaps* former);
    void warm_up();
    /// Draws the present view for PreparedMaps.
    void draw_at(const glm::vec2& jitter);
    [[nodiscard]] ImageSettings image_settings() const;
    /// Of what is curved; made when it is first needed.
    PredictionDrawer& prediction_drawer();
    /// Errors of what is curved, as `tell` tells them, and of plane mirrors.
    template <typename Errors, typename Tell>
    std::vector<Errors> find_errors(const Errors& of_image, const Errors& without_image, Tell tell);

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    Camera camera_;
    MapKind kind_;
    RenderSettings settings_;
    MapSettings map_settings_;
    SurfaceLight& light_;
    PlaneMirrors mirrors_;
    std::unique_ptr<PreparedMaps> prepared_;
    std::unique_ptr<PlanarDrawer> drawer_;
    std::optional<ReflectorDrawer> curved_;  ///< whose errors are predicted
    std::optional<PredictionDrawer> prediction_drawer_;
    std::vector<MirrorImage> images_;
};

}  // namespace utsuri
