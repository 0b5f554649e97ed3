// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/attachment.h"
#include "gpu/pipeline_cache.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace utsuri {

/// Which fragments are kept. Depth is reversed: 1 at the near plane, 0 at infinity.
enum class DepthTest {
    nearer,  ///< than what was drawn so far, whose place they take; of equal ones the first
    equal    ///< to the depth drawn before, which stays
};

struct DepthState {
    DepthTest test = DepthTest::nearer;
    /// How far fragments are moved back first, in units in the last place of the largest depth of their
    /// triangle.
    float behind = 0.0f;
};

/// What fragments do to the colours of a picture.
struct ColourState {
    std::vector<vk::Format> formats = {kColourFormat};  ///< of the attachments that are drawn into together
    bool written = true;  ///< false where the fragment stage only tells which fragments count
};

/// A graphics pipeline made from embedded SPIR-V: triangles whose vertices the vertex stage pulls from
/// buffers, drawn on both sides. Move-only. The pipeline itself is the device's: see PipelineCache.
class RasterPipeline {
  public:
    /// @param fragment empty for a pipeline that draws depth alone
    /// @param push_bytes size of the push constant block that both stages see, at most 128
    RasterPipeline(Device& device, const std::string& name, std::span<const std::uint32_t> vertex,
                   std::span<const std::uint32_t> fragment, const Specialization& specialization,
                   std::uint32_t push_bytes, const DepthState& depth = {}, const ColourState& colour = {});
    RasterPipeline(RasterPipeline&& other) noexcept;
    RasterPipeline& operator=(RasterPipeline&& other) noexcept;
    ~RasterPipeline();

    /// Binds buffers; extra entries are passed over, a missing one is a failed check.
    [[nodiscard]] BindingSet bind(const Bindings& buffers) const {
        return pipeline_->interface.bind(buffers);
    }

    /// Records a draw of whole triangles, inside draw_into(). Vertex indices begin at 3 * first.
    template <typename Push>
    void draw(const vk::raii::CommandBuffer& commands, const BindingSet& bindings, const Push& push,
              std::uint32_t first, std::uint32_t triangles) const {
        draw_bytes(commands, bindings, std::as_bytes(std::span(&push, 1)), first, triangles);
    }

    /// Records a draw whose VkDrawIndirectCommand a kernel has written.
    /// @param index which of the commands in `arguments`
    template <typename Push>
    void draw_indirect(const vk::raii::CommandBuffer& commands, const BindingSet& bindings, const Push& push,
                       const Buffer& arguments, std::uint32_t index) const {
        draw_indirect_bytes(commands, bindings, std::as_bytes(std::span(&push, 1)), arguments, index);
    }

  private:
    void draw_indirect_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                             std::span<const std::byte> push, const Buffer& arguments,
                             std::uint32_t index) const;
    void draw_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                    std::span<const std::byte> push, std::uint32_t first, std::uint32_t triangles) const;

    std::shared_ptr<const Pipeline> pipeline_;
};

/// A colour attachment that is drawn into.
struct ColourTarget {
    const Attachment& attachment;
    std::optional<std::array<float, 4>> background;  ///< what it is cleared to; else it keeps what it holds
};

/// Records draws into attachments of one size, ordered after everything recorded or run before. Depth is
/// cleared.
/// @param record records the draws
void draw_into(const vk::raii::CommandBuffer& commands, std::span<const ColourTarget> colours,
               const Attachment& depth, const std::function<void()>& record);

/// A rectangle of pixels, from the top left corner of a picture.
struct PixelRect {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Records that the draws that follow, inside draw_into(), touch no pixel outside a rectangle.
void limit_to(const vk::raii::CommandBuffer& commands, const PixelRect& rectangle);

/// Records draws into a cleared pair of attachments of one size, ordered after everything recorded or run
/// before.
/// @param background the colour where nothing is drawn
/// @param record records the draws
void draw_into(const vk::raii::CommandBuffer& commands, const Attachment& colour, const Attachment& depth,
               const std::array<float, 4>& background, const std::function<void()>& record);

}  // namespace utsuri
