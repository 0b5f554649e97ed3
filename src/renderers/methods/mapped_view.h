// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/prepared_maps.h"
#include "renderers/methods/view_drawer.h"
#include "renderers/reflection/raster/frame_drawer.h"
#include "renderers/reflection/raster/prediction_drawer.h"

#include <optional>

namespace utsuri {

/// A view in which all mirrors look their reflections up in maps, or, with MapKind::hybrid, follow rays where
/// maps are not right enough.
class MappedView : public ViewDrawer {
  public:
    /// All of them must outlive this.
    /// @param maps of all reflective instances
    MappedView(Device& device, const SceneData& data, const PreparedMaps& maps, MapKind kind,
               const RenderSettings& settings, const MapSettings& map_settings);

    void warm_up() override;
    void set_camera(const Camera& camera) override;
    double prepare_view() override;
    void record(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame) const override;
    [[nodiscard]] const Attachment& picture() const override { return drawer_.picture(); }
    [[nodiscard]] DeferredPicture deferred_picture() const override {
        return drawer_.deferred_picture(camera_info());
    }
    /// Need MapSettings::predicts_errors, where the kind of map keeps no distances.
    [[nodiscard]] std::vector<PredictedError> predict_errors() override;
    [[nodiscard]] std::vector<MeasuredError> measure_errors() override;

    /// None where nothing is reflective.
    [[nodiscard]] const ReflectorDrawer* reflectors() const { return reflectors_.get(); }

  private:
    [[nodiscard]] std::unique_ptr<ReflectorDrawer> make_reflectors() const;
    [[nodiscard]] interop::CameraInfo camera_info() const;
    /// Made when it is first needed.
    PredictionDrawer& prediction_drawer();
    /// Up to what prediction no search is made, in pixels.
    [[nodiscard]] float searching_tolerance() const;

    Device& device_;
    const SceneData& data_;
    const PreparedMaps& maps_;
    MapKind kind_;
    RenderSettings settings_;
    MapSettings map_settings_;
    Camera camera_;
    bool has_moved_ = true;
    std::unique_ptr<ReflectorDrawer> reflectors_;
    FrameDrawer drawer_;
    std::optional<PredictionDrawer> prediction_drawer_;
};

}  // namespace utsuri
