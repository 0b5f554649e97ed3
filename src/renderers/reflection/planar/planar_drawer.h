// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/planar/mirrored_view_drawer.h"
#include "renderers/reflection/raster/deferred_tracer.h"

namespace utsuri {

/// Draws one view of a scene with what its plane mirrors show: the view itself, then the views of one
/// reflection, of two, and so on. A pixel shows at most one view of each number of reflections.
class PlanarDrawer {
  public:
    /// @param bindings of scene, kept light, maps and BINDING_FRAME; the last and the states of the maps
    /// must outlive this
    /// @param curved reflectors with maps
    /// @param kind of the maps: see MirroredViewDrawer
    /// @param faces of the maps
    /// @throws DeviceError if the device cannot draw pictures of this size
    PlanarDrawer(Device& device, const SceneData& data, const PlaneMirrors& mirrors, const Reflectors& curved,
                 MapKind kind, const std::vector<interop::MapFace>& faces,
                 const Specialization& specialization, const Bindings& bindings, std::uint32_t width,
                 std::uint32_t height);

    /// Makes the driver compile what record() needs.
    void warm_up();

    /// Records the drawing of one picture.
    /// @param views plan_mirrored_views() for a picture of this size
    void record(const vk::raii::CommandBuffer& commands, const std::vector<MirroredView>& views,
                const interop::FrameInfo& frame) const;
    /// What it draws into: see lib/pixel_state.glsl for its fourth channel.
    [[nodiscard]] const Attachment& picture() const { return colour_; }
    /// What the last record() left to rays. Only where it defers_reflections().
    /// @param views of that record()
    [[nodiscard]] DeferredPicture deferred_picture(const std::vector<MirroredView>& views) const;

  private:
    [[nodiscard]] Bindings with_pictures(Bindings bindings) const;
    /// @param background what all are cleared to; none keeps what they hold
    [[nodiscard]] std::vector<ColourTarget> targets(
        const std::optional<std::array<float, 4>>& background) const;

    Device& device_;
    const Buffer& frame_;
    std::array<float, 4> background_;
    Attachment colour_;
    Attachment throughput_;
    std::optional<Attachment> deferred_;
    Attachment depth_;
    Buffer drawn_before_;
    Buffer throughput_before_;
    MirroredViewDrawer drawer_;
};

}  // namespace utsuri
