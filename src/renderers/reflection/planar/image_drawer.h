// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/planar/image_triangles.h"
#include "renderers/reflection/planar/mirror_images.h"
#include "renderers/reflection/reflectors/map_kind.h"

#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <optional>

namespace utsuri {

/// Draws images of a scene: see MirrorImage. Pixels that wait for an image show it, and wait for the next one
/// where they show a plane mirror.
class ImageDrawer {
  public:
    /// Colour attachments that are drawn into: what pixels show and wait for, and the throughput of mirrors.
    static constexpr std::uint32_t kColours = 2;

    /// @param bindings of scene, light cache, maps, and of what pixels showed before this image:
    /// BINDING_DRAWN, BINDING_THROUGHPUT
    /// @param kind of the maps: proxy, or hybrid with a tolerance of place, which follows rays where maps are
    /// not right enough and where a mirror's image is not drawn
    /// @param faces of the maps
    ImageDrawer(Device& device, const SceneData& data, const PlaneMirrors& mirrors, const Reflectors& curved,
                MapKind kind, const std::vector<interop::MapFace>& faces,
                const Specialization& specialization, const Bindings& bindings);

    /// Records a draw of one triangle by each pipeline, so that drivers compile them.
    void warm_up(const vk::raii::CommandBuffer& commands) const;

    /// Records the draws, inside draw_into().
    /// @param images of the frame
    /// @param index which of them
    /// @param most_depth reflections after which chains are cut
    void draw(const vk::raii::CommandBuffer& commands, const std::vector<MirrorImage>& images,
              std::uint32_t index, std::uint32_t most_depth) const;

  private:
    struct Pass {
        RasterPipeline pipeline;
        BindingSet bindings;
    };
    struct Batch {
        Pass pass;
        TriangleRange range;
    };
    ImageDrawer(Device& device, const SceneData& data, ImageTriangles triangles, MapKind kind,
                const std::vector<interop::MapFace>& faces, const Specialization& specialization,
                const Bindings& bindings);
    [[nodiscard]] Bindings all_bindings(Bindings bindings) const;
    [[nodiscard]] Pass make_pass(const std::string& name, std::span<const std::uint32_t> vertex,
                                 std::span<const std::uint32_t> fragment, DepthTest depth,
                                 const Specialization& specialization, const Bindings& bindings) const;
    void draw_depth(const vk::raii::CommandBuffer& commands, const MirrorImage& image,
                    const interop::ImagePush& push) const;
    void draw_mirrors(const vk::raii::CommandBuffer& commands, const MirrorImage& image,
                      interop::ImagePush push, std::uint32_t most_depth) const;

    Device& device_;
    ImageTriangles triangles_;
    Buffer list_;
    Buffer listed_reflectors_;
    Pass eye_depth_;
    std::vector<Batch> batches_;
    std::optional<Pass> curved_;  ///< like the others below only where the scene requires it
    std::optional<Pass> image_depth_;
    std::optional<Pass> mirrors_;
    std::optional<Pass> traced_mirrors_;  ///< whose images are not drawn
    std::optional<Pass> surroundings_;
};

}  // namespace utsuri
