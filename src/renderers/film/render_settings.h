// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace utsuri {

/// What every method is told.
struct RenderSettings {
    std::uint32_t width = 512;
    std::uint32_t height = 384;
    std::uint32_t seed = 0;
    std::uint32_t max_depth = 8;  ///< most specular reflections followed
    /// Traced pictures take what diffuse lobes send out from the light kept on surfaces, as drawn ones always
    /// do: what they differ by is then due to reflections.
    bool kept_light = false;
};

}  // namespace utsuri
