// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/planar/image_drawer.h"
#include "renderers/reflection/raster/drawn_samples.h"

namespace utsuri {

/// What pictures with images in plane mirrors are drawn with.
struct ImageSettings {
    std::uint32_t seed = 0;
    std::uint32_t specular_depth = 8;  ///< of rays
    float tolerance = 0.0f;            ///< Tolerance::most, of MapKind::hybrid
};

/// Draws one view of a scene with what its plane mirrors show: the view itself, then the images of one
/// reflection, of two, and so on. A pixel shows at most one image of each number of reflections.
class PlanarDrawer {
  public:
    /// @param bindings of scene, light cache, maps and BINDING_FRAME; the last and the states of the maps
    /// must outlive this
    /// @param curved reflectors with maps
    /// @param kind of the maps: see ImageDrawer
    /// @param faces of the maps
    /// @throws DeviceError if the device cannot draw pictures of this size
    PlanarDrawer(Device& device, const SceneData& data, const PlaneMirrors& mirrors, const Reflectors& curved,
                 MapKind kind, const std::vector<interop::MapFace>& faces,
                 const Specialization& specialization, const Bindings& bindings, std::uint32_t width,
                 std::uint32_t height);

    /// Makes the driver compile what add_samples() needs.
    void warm_up();

    /// Draws one picture and leaves it for pixels().
    /// @param images plan_mirror_images() for a picture of this size
    /// @param jitter where in its pixel each sample lies, in [0, 1)^2
    void draw_frame(const std::vector<MirrorImage>& images, const ImageSettings& settings,
                    const glm::vec2& jitter);
    /// See picture_pixels().
    [[nodiscard]] std::vector<glm::vec4> pixels() const;

    /// @param images as above
    /// @param complete see DrawnSamples::add()
    FrameCounts add_samples(Film& film, const std::vector<MirrorImage>& images, const ImageSettings& settings,
                            std::uint32_t count, Progress& progress, const CompleteMaps& complete);

    /// Distance of the near plane, scene space.
    [[nodiscard]] float near_plane() const { return info_.near_plane; }

  private:
    [[nodiscard]] Bindings with_pictures(Bindings bindings) const;
    [[nodiscard]] interop::FrameInfo frame_of(const ImageSettings& settings) const;
    void draw(const vk::raii::CommandBuffer& commands, const std::vector<MirrorImage>& images,
              const interop::FrameInfo& frame) const;

    Device& device_;
    interop::FrameInfo info_;
    const Buffer& frame_;
    std::array<float, 4> background_;
    Attachment colour_;
    Attachment throughput_;
    Attachment depth_;
    Buffer drawn_before_;
    Buffer throughput_before_;
    DrawnSamples samples_;
    ImageDrawer drawer_;
};

}  // namespace utsuri
