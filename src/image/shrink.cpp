// SPDX-License-Identifier: Apache-2.0
#include "image/shrink.h"

#include "base/check.h"

#include <algorithm>

namespace utsuri {
namespace {

std::uint32_t divide_up(std::uint32_t a, std::uint32_t b) {
    return (a + b - 1) / b;
}

glm::vec3 mean_of_square(const Image& image, std::uint32_t x0, std::uint32_t y0, std::uint32_t side) {
    const std::uint32_t x1 = std::min(x0 + side, image.width);
    const std::uint32_t y1 = std::min(y0 + side, image.height);
    glm::dvec3 sum(0.0);
    for (std::uint32_t y = y0; y < y1; ++y) {
        for (std::uint32_t x = x0; x < x1; ++x)
            sum += glm::dvec3(image.at(x, y));
    }
    return glm::vec3(sum / (static_cast<double>(x1 - x0) * static_cast<double>(y1 - y0)));
}

}  // namespace

Image shrink_to_width(const Image& image, std::uint32_t most_columns) {
    UTSURI_CHECK_LT(0u, most_columns);
    if (image.width <= most_columns) return image;
    const std::uint32_t side = divide_up(image.width, most_columns);
    Image shrunk(divide_up(image.width, side), divide_up(image.height, side));
    for (std::uint32_t y = 0; y < shrunk.height; ++y) {
        for (std::uint32_t x = 0; x < shrunk.width; ++x)
            shrunk.at(x, y) = mean_of_square(image, x * side, y * side, side);
    }
    return shrunk;
}

}  // namespace utsuri
