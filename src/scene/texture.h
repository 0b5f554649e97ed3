// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace utsuri {

/// Eight-bit RGBA texels as stored in the file, row-major, top row first (glTF: v = 0 is the top row).
/// Colour textures are sRGB coded, data textures linear; which, is decided by the slot that refers to them.
struct Texture {
    std::string name;
    std::uint32_t width = 0;         ///< texels, >= 1
    std::uint32_t height = 0;        ///< texels, >= 1
    std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes
};

enum class TextureWrap : std::uint32_t { repeat = 0, clamp_to_edge = 1, mirrored_repeat = 2 };
enum class TextureFilter : std::uint32_t { nearest = 0, linear = 1 };

/// How a material looks a texture up. `texture` is an index into Scene::textures, or -1 for none.
struct TextureSlot {
    std::int32_t texture = -1;
    TextureWrap wrap_s = TextureWrap::repeat;
    TextureWrap wrap_t = TextureWrap::repeat;
    TextureFilter filter = TextureFilter::linear;

    [[nodiscard]] bool used() const { return texture >= 0; }
};

}  // namespace utsuri
