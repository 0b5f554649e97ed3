// SPDX-License-Identifier: Apache-2.0
#include "image/metrics.h"

#include "base/check.h"
#include "base/error.h"
#include "image/colour.h"
#include "image/ssim.h"
#include "image/tone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace utsuri {
namespace {

constexpr int kChannels = 3;
constexpr double kPercentile = 0.999;

void require_same_size(const Image& reference, const Image& test) {
    if (reference.same_size(test)) return;
    throw InputError(
        "compare images", "",
        fmt::format("the reference has {} x {} pixels, the test image {} x {}; both must have the same size",
                    reference.width, reference.height, test.width, test.height));
}

void require_valid(const MetricSettings& settings) {
    if (settings.epsilon > 0.0 && std::isfinite(settings.epsilon)) return;
    throw UsageError("compare images", "",
                     fmt::format("epsilon is {}, expected a positive number", settings.epsilon));
}

double exposure_of(const Image& reference, const MetricSettings& settings) {
    return settings.exposure ? *settings.exposure : auto_exposure(reference);
}

bool comparable(const glm::vec3& reference, const glm::vec3& test) {
    return is_finite(reference) && is_finite(test);
}

/// Display coded; black in both where the two cannot be compared.
Image display_coded(const Image& image, const Image& other, double scale) {
    Image coded(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (comparable(image.pixels[i], other.pixels[i]))
            coded.pixels[i] = display_code(image.pixels[i], scale);
    }
    return coded;
}

/// Sums over the selected pixels, in double: 2^28 pixels of one sign lose at most 2^-25 of their sum.
struct Sums {
    double squared = 0.0;
    double relative_squared = 0.0;
    double relative_absolute = 0.0;
    double coded_squared = 0.0;
    double ssim = 0.0;
    double flip = 0.0;
    std::vector<double> largest;  ///< per pixel, over the channels
};

void add_pixel(const glm::vec3& reference, const glm::vec3& test, double scale, double epsilon, Sums& sums) {
    double largest = 0.0;
    for (int c = 0; c < kChannels; ++c) {
        const double r = static_cast<double>(reference[c]) * scale;
        const double d = static_cast<double>(test[c]) * scale - r;
        sums.squared += d * d;
        sums.relative_squared += d * d / (r * r + epsilon);
        sums.relative_absolute += std::abs(d) / (std::abs(r) + epsilon);
        largest = std::max(largest, std::abs(d));
    }
    sums.largest.push_back(largest);
}

double coded_squared_difference(const glm::vec3& reference, const glm::vec3& test, double display_scale) {
    const glm::vec3 r = display_code(reference, display_scale);
    const glm::vec3 t = display_code(test, display_scale);
    double sum = 0.0;
    for (int c = 0; c < kChannels; ++c) {
        const double d = static_cast<double>(t[c]) - static_cast<double>(r[c]);
        sum += d * d;
    }
    return sum;
}

void finish(Sums& sums, bool with_maps, Metrics& metrics) {
    metrics.pixels = sums.largest.size();
    if (metrics.pixels == 0) return;
    const auto pixels = static_cast<double>(metrics.pixels);
    const double values = kChannels * pixels;
    metrics.mse = sums.squared / values;
    metrics.rel_mse = sums.relative_squared / values;
    metrics.mape = sums.relative_absolute / values;
    metrics.psnr = -10.0 * std::log10(sums.coded_squared / values);
    if (with_maps) {
        metrics.ssim = sums.ssim / pixels;
        metrics.flip = sums.flip / pixels;
    }
    metrics.max = *std::max_element(sums.largest.begin(), sums.largest.end());
    const auto nth = sums.largest.begin() + static_cast<std::ptrdiff_t>(std::ceil(kPercentile * pixels)) - 1;
    std::nth_element(sums.largest.begin(), nth, sums.largest.end());
    metrics.p999 = *nth;
}

}  // namespace

double normalisation(const Image& reference) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const glm::vec3& pixel : reference.pixels) {
        if (!is_finite(pixel)) continue;
        sum += static_cast<double>(luminance(pixel));
        ++count;
    }
    return sum > 0.0 ? static_cast<double>(count) / sum : 1.0;
}

PerceptualMaps compute_perceptual_maps(const Image& reference, const Image& test,
                                       const MetricSettings& settings) {
    require_same_size(reference, test);
    require_valid(settings);
    const double stops = exposure_of(reference, settings);
    const double scale = exposure_scale(stops);
    PerceptualMaps maps;
    maps.ssim = ssim_map(display_coded(reference, test, scale), display_coded(test, reference, scale));
    maps.flip = settings.flip_hdr ? flip_hdr(reference, test, settings.flip)
                                  : flip_ldr(reference, test, settings.flip, stops);
    return maps;
}

Metrics compute_metrics(const Image& reference, const Image& test, const PerceptualMaps* maps,
                        const Mask* mask, const MetricSettings& settings) {
    require_same_size(reference, test);
    require_valid(settings);
    const std::size_t count = reference.pixels.size();
    if (mask != nullptr) UTSURI_CHECK_EQ(mask->size(), count);
    if (maps != nullptr) {
        UTSURI_CHECK_EQ(maps->ssim.values.size(), count);
        UTSURI_CHECK_EQ(maps->flip.values.size(), count);
    }
    const double scale = settings.normalise ? normalisation(reference) : 1.0;
    const double display_scale = exposure_scale(exposure_of(reference, settings));

    Metrics metrics;
    Sums sums;
    for (std::size_t i = 0; i < count; ++i) {
        if (mask != nullptr && (*mask)[i] == 0) continue;
        const glm::vec3& r = reference.pixels[i];
        const glm::vec3& t = test.pixels[i];
        if (!comparable(r, t)) {
            ++metrics.nonfinite;
            continue;
        }
        add_pixel(r, t, scale, settings.epsilon, sums);
        sums.coded_squared += coded_squared_difference(r, t, display_scale);
        if (maps != nullptr) {
            sums.ssim += static_cast<double>(maps->ssim.values[i]);
            sums.flip += static_cast<double>(maps->flip.values[i]);
        }
    }
    finish(sums, maps != nullptr, metrics);
    return metrics;
}

Metrics compute_metrics(const Image& reference, const Image& test, const Mask* mask,
                        const MetricSettings& settings) {
    const PerceptualMaps maps = compute_perceptual_maps(reference, test, settings);
    return compute_metrics(reference, test, &maps, mask, settings);
}

}  // namespace utsuri
