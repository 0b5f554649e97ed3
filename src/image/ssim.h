// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "image/plane.h"

namespace utsuri {

/// Structural similarity per pixel (Wang, Bovik, Sheikh, Simoncelli 2004): 11 x 11 Gaussian window of
/// deviation 1.5 pixels, population covariance, K1 = 0.01, K2 = 0.03, range 1. 1 where the pictures agree;
/// never above 1. Both images are display coded, finite and in [0, 1]; the luma is compared (Rec.709 weights
/// on code values). The whole frame is covered: the picture is mirrored at its borders, edge pixels repeated.
/// @pre both images have the same size.
[[nodiscard]] Plane ssim_map(const Image& reference, const Image& test);

}  // namespace utsuri
