// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/planar/mirrored_view_triangles.h"
#include "renderers/reflection/planar/mirrored_views.h"
#include "renderers/reflection/reflectors/map_kind.h"

#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <optional>

namespace utsuri {

/// Draws views of a scene: see MirroredView. Pixels that wait for a view show it, and wait for the next one
/// where they show a plane mirror.
class MirroredViewDrawer {
  public:
    /// @param bindings of scene, kept light, maps, and of what pixels showed before this view:
    /// BINDING_DRAWN, BINDING_THROUGHPUT
    /// @param kind of the maps: proxy, or hybrid with a tolerance of place, which leaves to rays where maps
    /// are not right enough and where a mirror's view is not drawn
    /// @param faces of the maps
    MirroredViewDrawer(Device& device, const SceneData& data, const PlaneMirrors& mirrors,
                       const Reflectors& curved, MapKind kind, const std::vector<interop::MapFace>& faces,
                       const Specialization& specialization, const Bindings& bindings);

    /// Records a draw of one triangle by each pipeline, so that drivers compile them.
    void warm_up(const vk::raii::CommandBuffer& commands) const;

    /// Records the draws, inside draw_into() attachments of drawn_formats().
    /// @param views of the frame
    /// @param index which of them
    void draw(const vk::raii::CommandBuffer& commands, const std::vector<MirroredView>& views,
              std::uint32_t index) const;

  private:
    struct Pass {
        RasterPipeline pipeline;
        BindingSet bindings;
    };
    struct Batch {
        Pass pass;
        TriangleRange range;
    };
    MirroredViewDrawer(Device& device, const SceneData& data, MirroredViewTriangles triangles, MapKind kind,
                       const std::vector<interop::MapFace>& faces, const Specialization& specialization,
                       const Bindings& bindings);
    [[nodiscard]] Bindings all_bindings(Bindings bindings) const;
    [[nodiscard]] Pass make_pass(const std::string& name, std::span<const std::uint32_t> vertex,
                                 std::span<const std::uint32_t> fragment, DepthTest depth,
                                 const Specialization& specialization, const Bindings& bindings) const;
    void draw_depth(const vk::raii::CommandBuffer& commands, const MirroredView& view,
                    const interop::ViewPush& push) const;
    void draw_mirrors(const vk::raii::CommandBuffer& commands, const MirroredView& view,
                      interop::ViewPush push) const;

    Device& device_;
    bool defers_;  ///< reflections to rays
    MirroredViewTriangles triangles_;
    Buffer list_;
    Buffer listed_reflectors_;
    Pass eye_depth_;
    std::vector<Batch> batches_;
    std::optional<Pass> curved_;  ///< like the others below only where the scene requires it
    std::optional<Pass> view_depth_;
    std::optional<Pass> mirrors_;
    std::optional<Pass> environment_;
};

}  // namespace utsuri
