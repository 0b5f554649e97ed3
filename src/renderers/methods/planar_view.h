// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/prepared_maps.h"
#include "renderers/methods/view_drawer.h"
#include "renderers/reflection/planar/planar_drawer.h"
#include "renderers/reflection/raster/prediction_drawer.h"

#include <glm/vec4.hpp>

#include <optional>
#include <vector>

namespace utsuri {

/// Instances that take maps where plane mirrors are drawn: those with a reflective triangle in no plane
/// mirror.
std::vector<std::uint32_t> curved_instances(const SceneData& data, const PlaneMirrors& mirrors);

/// A view in which plane mirrors show the scene as drawn by mirrored cameras, to a depth; curved mirrors look
/// their reflections up in maps. With MapKind::hybrid, rays are followed where maps are not right enough, and
/// where the view in a mirror would cost more than they do.
class PlanarView : public ViewDrawer {
  public:
    /// All of them must outlive this.
    /// @param maps of curved_instances()
    /// @param kind of the maps: proxy, or hybrid with a tolerance of place
    PlanarView(Device& device, const SceneData& data, const PreparedMaps& maps, PlaneMirrors mirrors,
               MapKind kind, const RenderSettings& settings, const MapSettings& map_settings);

    void warm_up() override { drawer_.warm_up(); }
    void set_camera(const Camera& camera) override;
    double prepare_view() override { return 0.0; }
    void record(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame) const override;
    [[nodiscard]] const Attachment& picture() const override { return drawer_.picture(); }
    [[nodiscard]] DeferredPicture deferred_picture() const override {
        return drawer_.deferred_picture(views_);
    }
    /// Of MapKind::hybrid only. Plane mirrors show what rays would, and nothing off its place; what their
    /// views do not show could be off by anything, were it not traced.
    [[nodiscard]] std::vector<PredictedError> predict_errors() override;
    [[nodiscard]] std::vector<MeasuredError> measure_errors() override;

    [[nodiscard]] const PlaneMirrors& mirrors() const { return mirrors_; }
    /// What a frame draws.
    [[nodiscard]] const std::vector<MirroredView>& views() const { return views_; }

  private:
    [[nodiscard]] interop::CameraInfo camera_info() const;
    /// Of curved mirrors; made when it is first needed.
    PredictionDrawer& prediction_drawer();
    /// Errors of curved mirrors, as `tell` tells them, and of plane ones.
    /// @param pixels of picture()
    template <typename Errors, typename Tell>
    std::vector<Errors> find_errors(const std::vector<glm::vec4>& pixels, const Errors& of_view,
                                    const Errors& without_view, Tell tell);

    Device& device_;
    const SceneData& data_;
    const PreparedMaps& maps_;
    PlaneMirrors mirrors_;
    MapKind kind_;
    RenderSettings settings_;
    MapSettings map_settings_;
    Camera camera_;
    std::vector<MirroredView> views_;
    PlanarDrawer drawer_;
    std::optional<ReflectorDrawer> curved_;  ///< whose errors are predicted
    std::optional<PredictionDrawer> prediction_drawer_;
};

}  // namespace utsuri
