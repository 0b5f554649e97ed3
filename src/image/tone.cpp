// SPDX-License-Identifier: Apache-2.0
#include "image/tone.h"

#include "image/colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace utsuri {
namespace {

constexpr glm::vec3 kNonFiniteColour{1.0f, 0.0f, 1.0f};

}  // namespace

double auto_exposure(const Image& reference) {
    std::vector<float> luminances;
    luminances.reserve(reference.pixels.size());
    for (const glm::vec3& pixel : reference.pixels) {
        const float value = luminance(pixel);
        if (std::isfinite(value) && value > 0.0f) luminances.push_back(value);
    }
    if (luminances.empty()) return 0.0;
    const double rank = std::ceil(kAutoExposurePercentile * static_cast<double>(luminances.size()));
    const auto nth = luminances.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(luminances.begin(), nth, luminances.end());
    return std::log2(kAutoExposureLevel / static_cast<double>(*nth));
}

Image to_display(const Image& linear, double stops) {
    const double scale = exposure_scale(stops);
    Image display(linear.width, linear.height);
    std::transform(linear.pixels.begin(), linear.pixels.end(), display.pixels.begin(),
                   [scale](const glm::vec3& pixel) {
                       return is_finite(pixel) ? display_code(pixel, scale) : kNonFiniteColour;
                   });
    return display;
}

}  // namespace utsuri
