// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/attachment.h"
#include "gpu/pipeline_interface.h"

#include <array>
#include <functional>

namespace utsuri {

/// A graphics pipeline made from embedded SPIR-V: triangles whose vertices the vertex stage pulls from
/// storage buffers, drawn on both sides, the nearest winning. Depth is reversed: 1 at the near plane, 0 at
/// infinity. Move-only.
class RasterPipeline {
  public:
    /// @param push_bytes size of the push constant block that both stages see, at most 128
    RasterPipeline(Device& device, const std::string& name, std::span<const std::uint32_t> vertex,
                   std::span<const std::uint32_t> fragment, const Specialization& specialization,
                   std::uint32_t push_bytes);
    RasterPipeline(RasterPipeline&& other) noexcept;
    RasterPipeline& operator=(RasterPipeline&& other) noexcept;
    ~RasterPipeline();

    /// Binds buffers; extra entries are passed over, a missing one is a failed check.
    [[nodiscard]] BindingSet bind(const Bindings& buffers) const { return interface_.bind(buffers); }

    /// Records a draw of whole triangles, inside draw_into().
    template <typename Push>
    void draw(const vk::raii::CommandBuffer& commands, const BindingSet& bindings, const Push& push,
              std::uint32_t triangles) const {
        draw_bytes(commands, bindings, std::as_bytes(std::span(&push, 1)), triangles);
    }

  private:
    void draw_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                    std::span<const std::byte> push, std::uint32_t triangles) const;

    PipelineInterface interface_;
    vk::raii::Pipeline pipeline_;
};

/// Records draws into a cleared pair of attachments of one size, ordered after everything recorded or run
/// before.
/// @param background the colour where nothing is drawn
/// @param record records the draws
void draw_into(const vk::raii::CommandBuffer& commands, const Attachment& colour, const Attachment& depth,
               const std::array<float, 4>& background, const std::function<void()>& record);

}  // namespace utsuri
