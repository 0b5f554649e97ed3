// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace utsuri {

/// Where auto_exposure puts the 90th percentile of luminance, as a fraction of display white: a third of a
/// stop below it, so that the brightest tenth keeps some gradation before it clips.
inline constexpr double kAutoExposureLevel = 0.8;
/// High enough that dark surroundings do not bleach the subject, low enough that a visible light source,
/// seldom more than a tenth of the frame, does not blacken it.
inline constexpr double kAutoExposurePercentile = 0.9;

/// The exposure in stops for showing `reference` and every picture compared with it: the 90th percentile
/// (nearest rank) of the finite, positive luminances is shown at kAutoExposureLevel of display white. Follows
/// the picture's scale: a picture 2^k times brighter gets k stops less. 0 for a picture without a positive
/// luminance.
[[nodiscard]] double auto_exposure(const Image& reference);

/// The picture as a display shows it after `stops` of exposure: clamped to [0, 1] and sRGB coded. Pixels that
/// are not finite become pure magenta, so that they are seen.
[[nodiscard]] Image to_display(const Image& linear, double stops);

}  // namespace utsuri
