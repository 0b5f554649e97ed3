// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

#include <cstdint>

namespace utsuri::test {

/// A picture of independent channel values, uniform in [0, 1), from a linear congruential generator.
inline Image noise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
    Image image(width, height);
    std::uint32_t state = seed;
    for (glm::vec3& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) {
            state = state * 1664525u + 1013904223u;
            pixel[c] = static_cast<float>(state >> 8) * 0x1p-24f;
        }
    }
    return image;
}

/// A picture whose pixel (x, y) is grey `value(x, y)`.
template <typename Value>
Image grey_picture(std::uint32_t width, std::uint32_t height, Value value) {
    Image image(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3(value(x, y));
    }
    return image;
}

}  // namespace utsuri::test
