// SPDX-License-Identifier: Apache-2.0
#include "image/flip.h"

#include "base/check.h"
#include "base/error.h"
#include "image/colour.h"
#include "image/flip_band.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace utsuri {
namespace {

/// Rows a band: high enough that its border of filter radius rows costs little, low enough to stay in the
/// cache.
constexpr std::uint32_t kBandRows = 64;
/// Below 4 the feature detectors are narrower than a pixel; above 1000 no display is.
constexpr double kMinPixelsPerDegree = 4.0;
constexpr double kMaxPixelsPerDegree = 1000.0;

/// What display white fraction the brightest and the median pixel are brought to (2021, section 4).
constexpr double kExposureLevel = 0.85;
/// A float's significand: what is 24 stops below the brightest pixel is less than that pixel's rounding.
constexpr double kMaxStops = 24.0;

/// Solves aces(x) = kExposureLevel: a quadratic with one positive root.
double exposure_target() {
    const double a = kAces.n2 - kExposureLevel * kAces.d2;
    const double b = kAces.n1 - kExposureLevel * kAces.d1;
    const double c = -kExposureLevel * kAces.d0;
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

/// The element at half the count, the upper of two middle ones, as in the authors' code.
double upper_median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

Plane run(const Image& reference, const Image& test, const FlipSettings& settings,
          const std::vector<FlipView>& views) {
    UTSURI_CHECK(reference.same_size(test));
    if (!(settings.pixels_per_degree >= kMinPixelsPerDegree &&
          settings.pixels_per_degree <= kMaxPixelsPerDegree)) {
        throw UsageError("compute FLIP", "",
                         fmt::format("{} pixels per degree, expected {} to {}", settings.pixels_per_degree,
                                     kMinPixelsPerDegree, kMaxPixelsPerDegree));
    }
    Plane map(reference.width, reference.height);
    if (map.values.empty()) return map;

    const FlipFilters filters(settings.pixels_per_degree);
    const std::uint32_t band_rows = std::min(kBandRows, map.height);
    const std::uint32_t bands = (map.height + band_rows - 1) / band_rows;
    const unsigned wanted = settings.threads > 0 ? settings.threads : std::thread::hardware_concurrency();
    const unsigned threads = std::clamp(wanted, 1u, bands);
    // All memory is taken here, since an exception could not leave a thread.
    std::vector<FlipBand> workers;
    for (unsigned i = 0; i < threads; ++i)
        workers.emplace_back(reference, test, filters, band_rows);

    std::atomic<std::uint32_t> next{0};
    const auto work = [&](FlipBand& worker) {
        for (std::uint32_t band = next++; band < bands; band = next++) {
            const std::uint32_t first = band * band_rows;
            worker.compute(first, std::min(band_rows, map.height - first), views, map);
        }
    };
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < threads; ++i)
        helpers.emplace_back([&, i] { work(workers[i]); });
    work(workers[0]);
    helpers.clear();  // joins
    return map;
}

/// Luminances as a display can show them: no negative channel, finite pixels only.
std::vector<float> shown_luminances(const Image& image) {
    std::vector<float> luminances;
    luminances.reserve(image.pixels.size());
    for (const glm::vec3& pixel : image.pixels) {
        if (is_finite(pixel)) luminances.push_back(luminance(glm::max(pixel, glm::vec3(0.0f))));
    }
    return luminances;
}

bool shows_anything(const Image& image) {
    const std::vector<float> luminances = shown_luminances(image);
    return std::any_of(luminances.begin(), luminances.end(), [](float value) { return value > 0.0f; });
}

}  // namespace

FlipExposures flip_exposures(const Image& reference) {
    std::vector<float> luminances = shown_luminances(reference);
    if (luminances.empty()) return {};
    const double brightest = static_cast<double>(*std::max_element(luminances.begin(), luminances.end()));
    if (!(brightest > 0.0)) return {};
    double median = upper_median(luminances);
    if (!(median > 0.0)) {
        std::erase_if(luminances, [](float value) { return !(value > 0.0f); });
        median = upper_median(luminances);
    }
    const double target = exposure_target();
    FlipExposures exposures;
    exposures.start = std::log2(target / brightest);
    exposures.stop = std::min(std::log2(target / median), exposures.start + kMaxStops);
    exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.stop - exposures.start)));
    return exposures;
}

Plane flip_ldr(const Image& reference, const Image& test, const FlipSettings& settings, double stops) {
    return run(reference, test, settings, {FlipView{exposure_scale(stops), false}});
}

Plane flip_hdr(const Image& reference, const Image& test, const FlipSettings& settings) {
    // A black reference has no exposure of its own; the other picture's shows the difference.
    const FlipExposures exposures = flip_exposures(shows_anything(reference) ? reference : test);
    std::vector<FlipView> views;
    for (int i = 0; i < exposures.count; ++i) {
        const double position = static_cast<double>(i) / static_cast<double>(exposures.count - 1);
        views.push_back(
            {exposure_scale(exposures.start + position * (exposures.stop - exposures.start)), true});
        if (exposures.start == exposures.stop) break;
    }
    return run(reference, test, settings, views);
}

}  // namespace utsuri
