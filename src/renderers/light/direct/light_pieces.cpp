// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/light_pieces.h"

#include "image/colour.h"

#include "interop/light_pieces.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace utsuri {
namespace {

constexpr std::uint32_t kFinest = 1u << (interop::LIGHT_PIECE_LEVELS - 1);

/// Samples along an edge of one of the finest pieces: one a texel, but no more than this many.
constexpr double kMostSamples = 32.0;

/// Number of a piece among the n^2 of its level.
std::uint32_t piece_at(std::uint32_t n, const glm::dvec2& b) {
    const double x = b.x * n;
    const double y = b.y * n;
    const auto i = static_cast<std::uint32_t>(x);
    const auto j = static_cast<std::uint32_t>(y);
    const bool turned = (x - i) + (y - j) > 1.0;
    return 2 * n * j - j * j + 2 * i + (turned ? 1 : 0);
}

std::uint32_t wrapped(double position, std::uint32_t size, std::uint32_t mode) {
    const auto n = static_cast<double>(size);
    double texel = std::floor(position);
    if (mode == interop::TEXTURE_CLAMP_TO_EDGE) {
        texel = std::clamp(texel, 0.0, n - 1.0);
    } else if (mode == interop::TEXTURE_MIRRORED_REPEAT) {
        texel -= 2.0 * n * std::floor(texel / (2.0 * n));
        if (texel >= n) texel = 2.0 * n - 1.0 - texel;
    } else {
        texel -= n * std::floor(texel / n);
    }
    return std::min(static_cast<std::uint32_t>(texel), size - 1);
}

/// Decoded bytes of the texel at a texture coordinate.
class TextureReader {
  public:
    TextureReader(const SceneData& data, const interop::TextureSlotInfo& slot) : data_(data), slot_(slot) {
        for (std::size_t byte = 0; byte < decoded_.size(); ++byte)
            decoded_[byte] = srgb_decode(static_cast<float>(byte) / 255.0f);
    }

    [[nodiscard]] glm::dvec3 operator()(const glm::dvec2& texcoord) const {
        const std::uint32_t x =
            wrapped(texcoord.x * slot_.width, slot_.width, slot_.sampling & interop::TEXTURE_WRAP_MASK);
        const std::uint32_t y =
            wrapped(texcoord.y * slot_.height, slot_.height,
                    (slot_.sampling >> interop::TEXTURE_WRAP_BITS) & interop::TEXTURE_WRAP_MASK);
        const std::uint32_t texel = data_.texels[slot_.first_texel + y * slot_.width + x];
        return {decoded_[texel & 0xffu], decoded_[(texel >> 8) & 0xffu], decoded_[(texel >> 16) & 0xffu]};
    }

  private:
    const SceneData& data_;
    const interop::TextureSlotInfo& slot_;
    std::array<float, 256> decoded_{};
};

/// Appends the pieces of one light.
void add_pieces(const SceneData& data, std::uint32_t triangle, std::vector<glm::vec3>& radiance) {
    const interop::TriangleInfo& info = data.triangle_infos[triangle];
    const interop::MaterialInfo& material = data.materials[info.material];
    const interop::TextureSlotInfo& slot = material.emissive_texture;
    const TextureReader texture(data, slot);
    const glm::dvec2 origin(data.texcoords[info.vertices.x]);
    const glm::dvec2 across = glm::dvec2(data.texcoords[info.vertices.y]) - origin;
    const glm::dvec2 up = glm::dvec2(data.texcoords[info.vertices.z]) - origin;
    const glm::dvec2 size(slot.width, slot.height);
    const double texels =
        std::max({glm::length(across * size), glm::length(up * size), glm::length((up - across) * size)});
    const auto samples =
        static_cast<std::uint32_t>(std::clamp(std::ceil(texels / kFinest), 2.0, kMostSamples));
    std::array<glm::dvec3, interop::LIGHT_PIECES> sums{};
    std::array<double, interop::LIGHT_PIECES> counts{};
    const std::uint32_t n = kFinest * samples;
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t k = 0; k < 2 * (n - j) - 1; ++k) {
            // The middle of a part of a still finer level.
            const double third = (k & 1u) == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
            const std::uint32_t i = k / 2;
            const glm::dvec2 b((i + third) / n, (j + third) / n);
            const glm::dvec3 colour = texture(origin + b.x * across + b.y * up);
            std::uint32_t first = 0;
            for (std::uint32_t level = 0; level < interop::LIGHT_PIECE_LEVELS; ++level) {
                const std::uint32_t piece = first + piece_at(1u << level, b);
                sums[piece] += colour;
                counts[piece] += 1.0;
                first += 1u << (2 * level);
            }
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        radiance.push_back(material.emissive * glm::vec3(sums[i] / std::max(counts[i], 1.0)));
}

}  // namespace

LightPieces find_light_pieces(const SceneData& data) {
    LightPieces pieces;
    for (const interop::LightInfo& light : data.lights) {
        const bool textured =
            light.type == interop::LIGHT_TRIANGLE &&
            data.materials[data.triangle_infos[light.triangle].material].emissive_texture.texture !=
                interop::NONE;
        pieces.first.push_back(textured ? static_cast<std::uint32_t>(pieces.radiance.size()) : interop::NONE);
        if (textured) add_pieces(data, light.triangle, pieces.radiance);
    }
    return pieces;
}

}  // namespace utsuri
