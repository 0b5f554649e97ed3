// SPDX-License-Identifier: Apache-2.0
#include "image/flip_band.h"

#include "image/colour.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace utsuri {
namespace {

/// The fit reaches 1 at 12.07 and stays above, so that clamping its argument here changes nothing, and its
/// squares stay finite.
constexpr double kAcesWhite = 16.0;

/// Andersson et al. 2020: exponent of the colour difference, and the point at which small and large ones
/// meet.
constexpr float kColourExponent = 0.7f;
constexpr float kKneeInput = 0.4f;
constexpr float kKneeOutput = 0.95f;
/// Exponent of the feature difference.
constexpr float kFeatureExponent = 0.5f;

float tone_map(double value) {
    const double x = std::min(value, kAcesWhite);
    const double mapped = (kAces.n2 * x + kAces.n1) * x / ((kAces.d2 * x + kAces.d1) * x + kAces.d0);
    return static_cast<float>(std::min(mapped, 1.0));
}

float show(float value, const FlipView& view) {
    const double scaled = std::max(0.0, static_cast<double>(value) * view.scale);
    return view.tone_mapped ? tone_map(scaled) : static_cast<float>(std::min(scaled, 1.0));
}

/// L* scales the chroma, since colours look less colourful in the dark (Hunt effect).
glm::vec3 hunt_adjusted(const glm::vec3& lab) {
    return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z};
}

/// Lightness by absolute, chroma by Euclidean distance (Abasi et al. 2020, HyAB).
float hyab(const glm::vec3& a, const glm::vec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

float redistribute(float difference, float largest) {
    const float knee = kKneeInput * largest;
    if (difference < knee) return kKneeOutput / knee * difference;
    return kKneeOutput + (difference - knee) / (largest - knee) * (1.0f - kKneeOutput);
}

}  // namespace

float largest_hyab() {
    const XyzSpace xyz;
    const auto lab = [&xyz](const glm::vec3& linear) {
        return hunt_adjusted(lab_from_relative_xyz(xyz.from_linear * linear / xyz.white));
    };
    return hyab(lab({0.0f, 1.0f, 0.0f}), lab({0.0f, 0.0f, 1.0f}));
}

FlipBand::FlipBand(const Image& reference, const Image& test, const FlipFilters& filters,
                   std::uint32_t max_rows)
    : reference_(reference),
      test_(test),
      filters_(filters),
      largest_colour_difference_(std::pow(largest_hyab(), kColourExponent)) {
    const std::size_t border = 2 * static_cast<std::size_t>(filters.radius);
    const std::size_t inner = static_cast<std::size_t>(reference.width) * max_rows;
    for (auto& channel : opponent_)
        channel.resize((reference.width + border) * (max_rows + border));
    row_filtered_.resize(reference.width * (max_rows + border));
    for (auto* values : {&filtered_[0], &filtered_[1], &filtered_[2], &gradient_x_, &gradient_y_}) {
        values->resize(inner);
    }
    for (Features* features : {&reference_features_, &test_features_}) {
        features->lab.resize(inner);
        features->edge.resize(inner);
        features->point.resize(inner);
    }
}

void FlipBand::compute(std::uint32_t first, std::uint32_t rows, const std::vector<FlipView>& views,
                       Plane& map) {
    first_ = first;
    rows_ = rows;
    float* out = map.values.data() + static_cast<std::size_t>(first) * map.width;
    const std::size_t count = static_cast<std::size_t>(rows) * map.width;
    for (const FlipView& view : views) {
        analyse(true, view, reference_features_);
        analyse(false, view, test_features_);
        for (std::size_t i = 0; i < count; ++i)
            out[i] = std::max(out[i], difference(i));
    }
}

void FlipBand::analyse(bool of_reference, const FlipView& view, Features& features) {
    load_opponent(of_reference, view);
    filter_colours(features);
    detect(filters_.edge, features.edge);
    detect(filters_.point, features.point);
}

void FlipBand::load_opponent(bool of_reference, const FlipView& view) {
    const Image& source = of_reference ? reference_ : test_;
    const Image& other = of_reference ? test_ : reference_;
    const std::int64_t radius = filters_.radius;
    const std::int64_t width = source.width + 2 * radius;
    std::size_t out = 0;
    for (std::int64_t row = 0; row < rows_ + 2 * radius; ++row) {
        const auto y = std::clamp<std::int64_t>(first_ + row - radius, 0, source.height - 1);
        for (std::int64_t column = 0; column < width; ++column, ++out) {
            const auto x = std::clamp<std::int64_t>(column - radius, 0, source.width - 1);
            const auto pixel = static_cast<std::size_t>(y * source.width + x);
            const glm::vec3& value = source.pixels[pixel];
            glm::vec3 shown(0.0f);
            if (is_finite(value) && is_finite(other.pixels[pixel])) {
                shown = {show(value.x, view), show(value.y, view), show(value.z, view)};
            }
            const glm::vec3 relative = xyz_.from_linear * shown / xyz_.white;
            opponent_[0][out] = 116.0f * relative.y - 16.0f;
            opponent_[1][out] = 500.0f * (relative.x - relative.y);
            opponent_[2][out] = 200.0f * (relative.y - relative.z);
        }
    }
}

/// Filters the rows of a bordered channel that lie within `vertical_reach` of the band.
void FlipBand::along_rows(const std::vector<float>& channel, const Kernel<float>& kernel,
                          std::vector<float>& out, int vertical_reach) {
    const auto radius = static_cast<std::size_t>(filters_.radius);
    const auto reach = static_cast<std::size_t>(vertical_reach);
    const std::size_t stride = reference_.width + 2 * radius;
    const std::size_t height = rows_ + 2 * reach;
    const Raster<const float> all{channel.data(), stride, rows_ + 2 * radius, stride};
    const std::size_t half = kernel.size() / 2;
    filter_rows(all.part(radius - half, radius - reach, reference_.width + 2 * half, height), kernel,
                Raster<float>{out.data(), reference_.width, height, reference_.width});
}

void FlipBand::along_columns(const std::vector<float>& in, const Kernel<float>& kernel,
                             std::vector<float>& out, bool accumulate) {
    const std::size_t width = reference_.width;
    filter_columns(Raster<const float>{in.data(), width, rows_ + kernel.size() - 1, width}, kernel,
                   Raster<float>{out.data(), width, rows_, width}, accumulate);
}

void FlipBand::apply_gaussian(const std::vector<float>& channel, const CsfGaussian& gaussian,
                              std::vector<float>& out, bool accumulate) {
    along_rows(channel, gaussian.along_rows, row_filtered_,
               static_cast<int>(gaussian.along_columns.size() / 2));
    along_columns(row_filtered_, gaussian.along_columns, out, accumulate);
}

void FlipBand::filter_colours(Features& features) {
    apply_gaussian(opponent_[0], filters_.achromatic, filtered_[0], false);
    apply_gaussian(opponent_[1], filters_.red_green, filtered_[1], false);
    apply_gaussian(opponent_[2], filters_.blue_yellow_narrow, filtered_[2], false);
    apply_gaussian(opponent_[2], filters_.blue_yellow_wide, filtered_[2], true);
    const std::size_t count = static_cast<std::size_t>(rows_) * reference_.width;
    for (std::size_t i = 0; i < count; ++i) {
        const float y = (filtered_[0][i] + 16.0f) / 116.0f;
        const glm::vec3 relative(y + filtered_[1][i] / 500.0f, y, y - filtered_[2][i] / 200.0f);
        const glm::vec3 linear =
            glm::clamp(xyz_.to_linear * (relative * xyz_.white), glm::vec3(0.0f), glm::vec3(1.0f));
        features.lab[i] = hunt_adjusted(lab_from_relative_xyz(xyz_.from_linear * linear / xyz_.white));
    }
}

/// The length of the gradient that `derivative` finds in the achromatic channel, whose black to white is one.
void FlipBand::detect(const Kernel<float>& derivative, std::vector<float>& strength) {
    const int reach = static_cast<int>(derivative.size() / 2);
    along_rows(opponent_[0], derivative, row_filtered_, reach);
    along_columns(row_filtered_, filters_.smooth, gradient_x_, false);
    along_rows(opponent_[0], filters_.smooth, row_filtered_, reach);
    along_columns(row_filtered_, derivative, gradient_y_, false);
    const std::size_t count = static_cast<std::size_t>(rows_) * reference_.width;
    for (std::size_t i = 0; i < count; ++i) {
        strength[i] = std::sqrt(gradient_x_[i] * gradient_x_[i] + gradient_y_[i] * gradient_y_[i]) / 116.0f;
    }
}

float FlipBand::difference(std::size_t i) const {
    const float colour =
        redistribute(std::pow(hyab(reference_features_.lab[i], test_features_.lab[i]), kColourExponent),
                     largest_colour_difference_);
    const float feature = std::max(std::abs(reference_features_.edge[i] - test_features_.edge[i]),
                                   std::abs(reference_features_.point[i] - test_features_.point[i]));
    // A kernel's rounded sum may pass one by a few units in the last place.
    const float exponent = 1.0f - std::min(1.0f, std::pow(feature / std::sqrt(2.0f), kFeatureExponent));
    return std::min(1.0f, std::pow(colour, exponent));
}

}  // namespace utsuri
