// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace utsuri {

/// How wrong what MapKind::hybrid looks up may be predicted to be; beyond it follows a ray.
struct Tolerance {
    enum class Of {
        place,    ///< pixels by which a reflection is off its place
        radiance  ///< error of a channel, relative to the brightest channel of what should be shown
    };
    Of of = Of::place;
    double most = 1.0;
};

/// Ranges that make sense. Below kLeastRadianceTolerance hybrid would follow the rounding of evenly lit
/// walls; what is shown black is wrong by kMostRadianceTolerance.
inline constexpr double kMostPlaceTolerance = 1e6;
inline constexpr double kLeastRadianceTolerance = 1e-4;
inline constexpr double kMostRadianceTolerance = 1.0;

}  // namespace utsuri
