// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace utsuri {

/// A picture of linear Rec.709 values, row-major, top row first. For rendered pictures a value is luminance
/// in cd/m2 per channel; any finite float is valid, negative ones too.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::vec3> pixels;  ///< width * height values

    Image() = default;
    Image(std::uint32_t w, std::uint32_t h, glm::vec3 value = glm::vec3(0.0f))
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, value) {}

    [[nodiscard]] glm::vec3& at(std::uint32_t x, std::uint32_t y) {
        return pixels[static_cast<std::size_t>(y) * width + x];
    }
    [[nodiscard]] const glm::vec3& at(std::uint32_t x, std::uint32_t y) const {
        return pixels[static_cast<std::size_t>(y) * width + x];
    }
    [[nodiscard]] bool same_size(const Image& other) const {
        return width == other.width && height == other.height;
    }
};

/// One flag a pixel, row-major, top row first; non-zero means "belongs to the mask".
using Mask = std::vector<std::uint8_t>;

}  // namespace utsuri
