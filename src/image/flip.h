// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "image/plane.h"

namespace utsuri {

struct FlipSettings {
    /// Pixels per degree of visual angle, [4, 1000]. The default is the papers': a 0.7 m wide display of 3840
    /// pixels seen from 0.7 m.
    double pixels_per_degree = 67.02064;
    /// Threads to use; 0 takes all cores. The map does not depend on it.
    unsigned threads = 0;
};

/// The exposures at which HDR-FLIP looks, in stops.
struct FlipExposures {
    double start = 0.0;  ///< the brightest reference pixel is shown at 0.85 of display white
    double stop = 0.0;   ///< the median reference pixel is shown at 0.85 of display white
    int count = 2;       ///< evenly spaced from start to stop, at least 2
};

/// LDR-FLIP (Andersson et al. 2020): per pixel, the difference in [0, 1] that an observer sees who flips
/// between the two pictures. Both images are linear; what a display cannot show is clamped to [0, 1]. Pixels
/// that are not finite in either image count as black in both.
/// @pre both images have the same size. @throws UsageError for settings out of range.
[[nodiscard]] Plane flip_ldr(const Image& reference, const Image& test, const FlipSettings& settings = {},
                             double stops = 0.0);

/// HDR-FLIP (Andersson et al. 2021): the largest LDR-FLIP over the exposures of flip_exposures, tone mapped
/// by a fit of ACES. The result is independent of a common scale of the two images.
[[nodiscard]] Plane flip_hdr(const Image& reference, const Image& test, const FlipSettings& settings = {});

/// The exposures for a reference (2021, section 4), with three cases that the paper leaves open: a median of
/// zero is replaced by the median of the positive luminances; the range is at most 24 stops, since what is
/// darker is less than a float's rounding of the brightest pixel; a reference without a positive luminance
/// gets 0, 0, 2.
[[nodiscard]] FlipExposures flip_exposures(const Image& reference);

}  // namespace utsuri
