// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/prepared_maps.h"
#include "renderers/methods/renderer.h"
#include "renderers/reflection/raster/frame_drawer.h"
#include "renderers/reflection/raster/prediction_drawer.h"

#include <memory>
#include <optional>
#include <vector>

namespace utsuri {

/// The methods that look reflections up in maps: the scene drawn by the raster pipeline, lit from light kept
/// on its surfaces, with what they reflect looked up in maps; all of that is made beforehand.
class MapRenderer : public Renderer {
  public:
    /// `device`, `data`, `scene` and `light` must outlive this.
    /// @param light is filled by the first renderer that needs it; its cost counts for each
    MapRenderer(Device& device, const SceneData& data, const GpuScene& scene, SurfaceLight& light,
                const Camera& camera, MapKind kind, const RenderSettings& settings,
                const MapSettings& map_settings);

    void prepare(Progress& progress) override;
    void update(const SceneChange& change, Progress& progress) override;

    /// Moves the eye: all that it costs is the pass over the reflectors' vertices and the drawing. A sphere
    /// map stays turned the way the first eye looked, until the scene changes.
    void set_camera(const Camera& camera) override;
    bool draw_frame() override;
    /// What draw_frame() drew.
    [[nodiscard]] Image frame() const { return drawer_->frame(); }

    /// Needs MapSettings::predicts_errors, where the kind of map keeps no distances.
    [[nodiscard]] std::vector<PredictedError> predict_errors() override;
    [[nodiscard]] std::vector<MeasuredError> measure_errors() override;
    /// Of MapKind::hybrid only. Draws the present view: frame() is it afterwards.
    [[nodiscard]] std::vector<float> traced_pixels() override;

    [[nodiscard]] const ReflectionMaps& maps() const { return prepared_->maps(); }
    [[nodiscard]] const RoughMaps& rough_maps() const { return prepared_->rough_maps(); }
    /// None where nothing is reflective.
    [[nodiscard]] const ReflectorDrawer* reflectors() const { return reflectors_.get(); }

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    /// @param former see PreparedMaps
    void make_drawers(PreparedMaps* former);
    void warm_up();
    /// Draws the present view for PreparedMaps.
    void draw_at(const glm::vec2& jitter);
    [[nodiscard]] DrawSettings draw_settings() const;
    /// The pass over the reflectors' polygons for the present eye.
    double reflect();
    [[nodiscard]] interop::CameraInfo camera_info() const;
    /// Made when it is first needed.
    PredictionDrawer& prediction_drawer();
    /// Up to what prediction no search is made, in pixels.
    [[nodiscard]] float searching_tolerance() const;

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    Camera camera_;
    bool eye_moved_ = true;
    RenderSettings settings_;
    MapSettings map_settings_;
    MapKind kind_;
    SurfaceLight& light_;
    std::unique_ptr<PreparedMaps> prepared_;
    std::unique_ptr<ReflectorDrawer> reflectors_;
    std::unique_ptr<FrameDrawer> drawer_;
    std::optional<PredictionDrawer> prediction_drawer_;
};

}  // namespace utsuri
