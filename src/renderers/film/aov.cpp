// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/aov.h"

#include "renderers/film/film.h"
#include "renderers/film/film_kernel.h"

#include "interop/bindings.h"
#include "kernels/aov.h"

#include <algorithm>

namespace utsuri {

std::vector<interop::AovPixel> render_aovs(Device& device, const GpuScene& scene,
                                           const interop::CameraInfo& camera, std::uint32_t width,
                                           std::uint32_t height) {
    const Kernel kernel(device, "aov", kernels::aov, scene.specialization(), sizeof(interop::FramePush));
    // One first hit costs little: a band of this many rows stays far under the time that drivers allow.
    constexpr std::uint32_t kMostRows = 128;
    // The rows of tiles that one dispatch has workgroups for.
    const std::uint32_t rows_of_groups =
        std::max(1u, kMaxGroups / tile_count(width, interop::TILE_SIZE)) * interop::TILE_SIZE;
    const std::uint32_t rows = std::min(
        {rows_per_band(device, width, sizeof(interop::AovPixel)), height, kMostRows, rows_of_groups});
    const Buffer pixels(device, std::uint64_t{width} * rows * sizeof(interop::AovPixel), "first hits");
    Bindings bindings = scene.bindings();
    bindings[interop::BINDING_AOV] = &pixels;
    const Buffer unused(device, sizeof(interop::FilmPixel), "no film");
    bindings[interop::BINDING_FILM] = &unused;
    const BindingSet set = kernel.bind(bindings);

    std::vector<interop::AovPixel> result;
    result.reserve(std::size_t{width} * height);
    interop::FramePush push{};
    push.camera = camera;
    push.width = width;
    push.height = height;
    push.excluded_instance = interop::NONE;
    for (std::uint32_t first = 0; first < height; first += rows) {
        push.first_row = first;
        push.rows = std::min(rows, height - first);
        device.run("find first hits", [&](const vk::raii::CommandBuffer& commands) {
            kernel.dispatch(commands, set, push, tile_count(width, push.rows));
        });
        const auto band = pixels.download_records<interop::AovPixel>(std::size_t{width} * push.rows);
        result.insert(result.end(), band.begin(), band.end());
    }
    return result;
}

Mask reflective_mask(const std::vector<interop::AovPixel>& aovs) {
    Mask mask(aovs.size());
    std::transform(aovs.begin(), aovs.end(), mask.begin(),
                   [](const interop::AovPixel& pixel) { return static_cast<std::uint8_t>(pixel.mirror); });
    return mask;
}

}  // namespace utsuri
