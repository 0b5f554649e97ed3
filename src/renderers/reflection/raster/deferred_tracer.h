// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/reflection/reflectors/map_kind.h"

#include "gpu/kernel.h"
#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <array>
#include <optional>
#include <vector>

namespace utsuri {

/// Whether drawn pixels leave reflections to rays, to a DeferredTracer: where there are any.
bool defers_reflections(const SceneData& data, MapKind kind);

/// Formats of the attachments that a view is drawn into: picture, the throughput of mirrored views if there
/// are any, and reflections left to rays.
std::vector<vk::Format> drawn_formats(bool defers_reflections, bool has_mirrored_views);

/// What reflections are drawn into; none if no pixel leaves any to rays.
std::optional<Attachment> make_deferred(Device& device, bool defers_reflections, std::uint32_t width,
                                        std::uint32_t height);
/// What it is cleared to: DEFERRED_NONE.
inline constexpr std::array<float, 4> kNothingDeferred = {0.0f, 0.0f, 0.0f, 0.0f};

/// A drawn picture, and what its pixels left to rays.
struct DeferredPicture {
    const Attachment& picture;
    const Attachment& reflections;  ///< interop::DeferredReflection
    const Attachment* throughput;   ///< of pixels that show mirrored views; none where no pixel does
    std::vector<interop::DeferredView> views;  ///< the eye's own first; at most DEFERRED_MOST_VIEWS
};

/// Follows the reflections that drawn pixels left to rays: deferred shading, over a list of those pixels.
class DeferredTracer {
  public:
    /// @param bindings of scene, kept light and BINDING_FRAME, which must outlive this
    DeferredTracer(Device& device, const Specialization& specialization, const Bindings& bindings,
                   std::uint32_t width, std::uint32_t height);

    /// Makes the driver compile what record() needs.
    void warm_up();
    /// Records the rays, after the drawing of the picture, and adds what they bring to it.
    void record(const vk::raii::CommandBuffer& commands, const DeferredPicture& drawn) const;

  private:
    [[nodiscard]] Bindings with_lists(Bindings bindings) const;

    Device& device_;
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t rows_of_bands_;
    Buffer drawn_;
    Buffer throughput_;
    Buffer reflections_;
    Buffer views_;
    Buffer count_;
    Buffer pixels_;
    Kernel list_;
    Kernel trace_;
    BindingSet list_set_;
    BindingSet trace_set_;
};

}  // namespace utsuri
