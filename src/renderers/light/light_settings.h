// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace utsuri {

/// How exactly light is kept on surfaces.
struct LightSettings {
    /// Distance of neighbouring points, at most, as a share of the diagonal of the scene's bounds, > 0.
    double spacing = 1.0 / 24.0;
    /// Per point and side, in [1, kMostLightSamples], but one for each lamp at least; fewer where the first
    /// ones agree.
    std::uint32_t samples = 64;
    std::uint32_t seed = 0;
    /// Points simulated by one dispatch, at most, >= 1: it takes no longer than drivers allow in any case.
    /// How the work is cut never changes the light.
    std::uint32_t points_per_dispatch = 0xffffffffu;
    /// Where light changes, points are nearer, but not by more than this, >= 1; at 1 they are spaced evenly.
    double refinement = 32.0;
    /// How far light between points may be from what they tell before there are more, as a share of it, >= 0.
    double tolerance = 0.03;
    /// Points more than the coarse ones, at most, where things touch, and as many where light changes; a
    /// device may have room for fewer.
    std::uint64_t most_points = std::uint64_t{1} << 18;
};

/// Bounded by what an invocation may do: see kQueriesPerInvocation in film_kernel.cpp.
inline constexpr std::uint32_t kMostLightSamples = 256;

}  // namespace utsuri
