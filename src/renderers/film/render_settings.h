// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace utsuri {

/// Largest edge of a picture, pixels: beyond it no format and no display that we know of follows.
inline constexpr std::uint32_t kLargestPictureEdge = 16384;

/// What every method is told.
struct RenderSettings {
    std::uint32_t width = 512;   ///< pixels, [1, kLargestPictureEdge]
    std::uint32_t height = 384;  ///< pixels, [1, kLargestPictureEdge]
    std::uint32_t seed = 0;
    std::uint32_t max_depth = 8;  ///< most specular reflections followed
    /// Traced pictures take what diffuse lobes send out from the light kept on surfaces, as drawn ones always
    /// do: what they differ by is then due to reflections.
    bool kept_light = false;
};

}  // namespace utsuri
