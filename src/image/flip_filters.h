// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/filter.h"

namespace utsuri {

/// A Gaussian of the contrast sensitivity function; its two-dimensional sum is the share of the whole filter.
struct CsfGaussian {
    Kernel<float> along_rows;
    Kernel<float> along_columns;  ///< carries the share
};

/// The filters of FLIP at one viewing distance (Andersson et al. 2020, sections 4.1.1 and 4.2), as separable
/// kernels.
struct FlipFilters {
    CsfGaussian achromatic;
    CsfGaussian red_green;
    CsfGaussian blue_yellow_narrow;
    CsfGaussian blue_yellow_wide;

    Kernel<float> smooth;  ///< sum one
    Kernel<float> edge;    ///< first derivative of `smooth`
    Kernel<float> point;   ///< second derivative of `smooth`

    int radius = 0;  ///< pixels, of the widest kernel

    explicit FlipFilters(double pixels_per_degree);
};

}  // namespace utsuri
