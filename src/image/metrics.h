// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/flip.h"
#include "image/image.h"
#include "image/plane.h"

#include <cstddef>
#include <limits>
#include <optional>

namespace utsuri {

/// How far a test picture is from a reference. NaN where there was nothing to measure.
struct Metrics {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    double mse = kNone;      ///< mean of d^2 over pixels and channels, d = test - reference
    double rel_mse = kNone;  ///< mean of d^2 / (reference^2 + epsilon)
    double mape = kNone;     ///< mean of |d| / (|reference| + epsilon)
    double psnr = kNone;     ///< dB, of the display-coded pictures, peak 1; infinity where they agree exactly
    double ssim = kNone;     ///< mean structural similarity of the display-coded pictures, at most 1
    double flip = kNone;     ///< mean FLIP, [0, 1]
    double max = kNone;      ///< largest |d| over pixels and channels
    double p999 = kNone;  ///< 99.9th percentile (nearest rank) over pixels of the largest |d| of the channels
    std::size_t pixels = 0;     ///< pixels measured: in the mask and finite in both pictures
    std::size_t nonfinite = 0;  ///< pixels of the mask left out because one picture is not finite there
};

struct MetricSettings {
    /// Divides both pictures by the mean luminance of the reference (whole frame, finite pixels) before mse,
    /// rel_mse, mape, max and p999, which makes them independent of the unit of light. A reference whose mean
    /// luminance is not positive is taken as it is.
    bool normalise = true;
    /// Added to the denominators of rel_mse and mape, > 0; with `normalise`, 1 % of the mean luminance.
    double epsilon = 0.01;
    /// Exposure in stops of the display-coded pictures (psnr, ssim, low dynamic range FLIP); auto_exposure of
    /// the reference when empty.
    std::optional<double> exposure{};
    /// HDR-FLIP if true, else LDR-FLIP at `exposure`.
    bool flip_hdr = true;
    FlipSettings flip{};
};

/// The maps that ssim and flip average, whole frame.
struct PerceptualMaps {
    Plane ssim;
    Plane flip;
};

/// Slow next to the sums, so that one call serves several masks and the error map.
/// @throws InputError if the sizes differ, UsageError if a setting is out of range.
[[nodiscard]] PerceptualMaps compute_perceptual_maps(const Image& reference, const Image& test,
                                                     const MetricSettings& settings = {});

/// Over the pixels of `mask` (all if null). ssim and flip are means of `maps` over those pixels, and stay NaN
/// when `maps` is null. An empty selection gives pixels = 0 and NaN throughout.
/// @throws InputError if the sizes differ, UsageError if a setting is out of range.
[[nodiscard]] Metrics compute_metrics(const Image& reference, const Image& test, const PerceptualMaps* maps,
                                      const Mask* mask, const MetricSettings& settings = {});

/// All metrics in one call.
[[nodiscard]] Metrics compute_metrics(const Image& reference, const Image& test, const Mask* mask = nullptr,
                                      const MetricSettings& settings = {});

/// The factor that MetricSettings::normalise applies: 1 / (mean luminance of the finite pixels), or 1.
[[nodiscard]] double normalisation(const Image& reference);

}  // namespace utsuri
