// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace utsuri {

/// How exactly light is kept on surfaces.
struct LightSettings {
    /// Distance of neighbouring points, at most, as a share of the diagonal of the scene's bounds, > 0.
    double spacing = 1.0 / 300.0;
    /// Per point and side, in [1, kMostLightSamples]; fewer where the first ones agree.
    std::uint32_t samples = 64;
    std::uint32_t seed = 0;
    /// Points simulated by one dispatch, at most, >= 1: it takes no longer than drivers allow in any case.
    /// How the work is cut never changes the light.
    std::uint32_t points_per_dispatch = 0xffffffffu;
};

/// Bounded by what an invocation may do: see kQueriesPerInvocation in film_kernel.cpp.
inline constexpr std::uint32_t kMostLightSamples = 256;

}  // namespace utsuri
