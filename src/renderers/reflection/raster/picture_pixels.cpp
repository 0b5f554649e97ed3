// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/picture_pixels.h"

#include "renderers/film/film.h"

#include "interop/raster.h"

#include <algorithm>

namespace utsuri {

std::vector<glm::vec4> picture_pixels(Device& device, const Attachment& picture) {
    const std::uint32_t width = picture.width();
    const std::uint32_t height = picture.height();
    const std::uint32_t rows = std::min(height, rows_per_band(device, width, sizeof(glm::vec4)));
    const Buffer copied(device, std::uint64_t{width} * rows * sizeof(glm::vec4), "rows of a picture");
    std::vector<glm::vec4> pixels;
    pixels.reserve(std::size_t{width} * height);
    for (std::uint32_t first = 0; first < height; first += rows) {
        const std::uint32_t count = std::min(rows, height - first);
        device.run("copy a picture", [&](const vk::raii::CommandBuffer& commands) {
            picture.copy_rows(commands, first, count, copied);
        });
        const auto band = copied.download_records<glm::vec4>(std::size_t{width} * count);
        pixels.insert(pixels.end(), band.begin(), band.end());
    }
    return pixels;
}

std::vector<float> traced_pixels_of(const std::vector<glm::vec4>& pixels) {
    std::vector<float> traced(pixels.size());
    std::transform(pixels.begin(), pixels.end(), traced.begin(), [](const glm::vec4& pixel) {
        if (pixel.w == interop::DRAWN_PLAIN) return -1.0f;
        return pixel.w >= interop::DRAWN_RAY ? 1.0f : 0.0f;
    });
    return traced;
}

}  // namespace utsuri
