// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/changed_bytes.h"
#include "renderers/device_scene/scene_data.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Gives each texture that some material refers to its place among the texels. The scene must outlive it.
class TextureTable {
  public:
    explicit TextureTable(const Scene& scene);

    [[nodiscard]] const std::vector<TextureHeader>& headers() const { return headers_; }
    /// Of the scene's textures, the one that a header is of.
    [[nodiscard]] std::uint32_t source(std::size_t header) const { return sources_[header]; }
    [[nodiscard]] const Texture& texture(std::size_t header) const;
    [[nodiscard]] std::uint64_t texels() const { return texels_; }
    /// How kernels look up what a slot refers to.
    [[nodiscard]] interop::TextureSlotInfo slot(const TextureSlot& slot) const;

  private:
    void add(const TextureSlot& slot);

    const Scene& scene_;
    std::vector<TextureHeader> headers_;
    std::vector<std::uint32_t> sources_;
    std::vector<std::uint32_t> indices_;  ///< of each texture's header, or interop::NONE
    std::uint64_t texels_ = 0;
};

/// What packing textures changed.
struct TextureChange {
    bool laid_out = false;          ///< they are others, or of other sizes: all are new
    std::vector<bool> textures;     ///< whether other texels are in it, of each header
    std::vector<ByteRange> ranges;  ///< of SceneData::texels that differ; none if laid_out
};

/// Makes headers, texels and facts of `data` those of the scene. Where the textures have the sizes that they
/// have there, only those are written that differ; what is known of the others stays.
TextureChange pack_textures(const TextureTable& table, SceneData& data);

/// What the scene requires but for the depth of chains: see scene/requirements.h. Textures are gone through
/// only where their facts do not tell.
Requirements find_requirements_but_depth(const Scene& scene, const TextureTable& table,
                                         std::vector<TextureFacts>& facts);

/// Mean over texels and colour channels of a texture, decoded by the power 2.2 that sRGB is close to, in [0,
/// 1].
double mean_colour(const Texture& texture);

}  // namespace utsuri
