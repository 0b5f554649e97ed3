// SPDX-License-Identifier: Apache-2.0
#include "image/ssim.h"

#include "base/check.h"
#include "image/colour.h"
#include "image/filter.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace utsuri {
namespace {

constexpr std::size_t kRadius = 5;
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

/// The nearest index inside [0, size) under mirroring with the edge repeated, for any picture size.
std::size_t mirrored(std::int64_t index, std::size_t size) {
    const auto period = 2 * static_cast<std::int64_t>(size);
    const std::int64_t phase = ((index % period) + period) % period;
    return static_cast<std::size_t>(phase < period / 2 ? phase : period - 1 - phase);
}

/// Rows of double: variances are differences of nearly equal means, in float they would lose SSIM's C2.
class Rows {
  public:
    Rows(std::size_t width, std::size_t height) : width_(width), height_(height), values_(width * height) {}
    [[nodiscard]] Raster<double> raster() { return {values_.data(), width_, height_, width_}; }
    [[nodiscard]] Raster<const double> raster() const { return {values_.data(), width_, height_, width_}; }
    [[nodiscard]] std::vector<double>& values() { return values_; }
    [[nodiscard]] const std::vector<double>& values() const { return values_; }

  private:
    std::size_t width_;
    std::size_t height_;
    std::vector<double> values_;
};

Rows padded_luma(const Image& image) {
    const std::size_t width = image.width + 2 * kRadius;
    const std::size_t height = image.height + 2 * kRadius;
    Rows rows(width, height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t source_y =
            mirrored(static_cast<std::int64_t>(y) - static_cast<std::int64_t>(kRadius), image.height);
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t source_x =
                mirrored(static_cast<std::int64_t>(x) - static_cast<std::int64_t>(kRadius), image.width);
            rows.values()[y * width + x] =
                static_cast<double>(luminance(image.pixels[source_y * image.width + source_x]));
        }
    }
    return rows;
}

Rows multiplied(const Rows& a, const Rows& b) {
    Rows product = a;
    for (std::size_t i = 0; i < product.values().size(); ++i)
        product.values()[i] *= b.values()[i];
    return product;
}

/// The mean of the window around each pixel of the frame inside the padding.
std::vector<double> window_mean(const Rows& padded, const Kernel<double>& kernel) {
    const Raster<const double> in = padded.raster();
    Rows along_rows(in.width - 2 * kRadius, in.height);
    filter_rows(in, kernel, along_rows.raster());
    Rows mean(in.width - 2 * kRadius, in.height - 2 * kRadius);
    const Rows& source = along_rows;
    filter_columns(source.raster(), kernel, mean.raster());
    return mean.values();
}

}  // namespace

Plane ssim_map(const Image& reference, const Image& test) {
    UTSURI_CHECK(reference.same_size(test));
    Plane map(reference.width, reference.height);
    if (map.values.empty()) return map;

    Kernel<double> kernel = sample_kernel<double>(static_cast<int>(kRadius), [](double offset) {
        return std::exp(-offset * offset / (2.0 * kDeviation * kDeviation));
    });
    normalise_by_sign(kernel);
    const Rows a = padded_luma(reference);
    const Rows b = padded_luma(test);
    const std::vector<double> mean_a = window_mean(a, kernel);
    const std::vector<double> mean_b = window_mean(b, kernel);
    const std::vector<double> mean_aa = window_mean(multiplied(a, a), kernel);
    const std::vector<double> mean_bb = window_mean(multiplied(b, b), kernel);
    const std::vector<double> mean_ab = window_mean(multiplied(a, b), kernel);
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const double squares = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
        const double product = mean_a[i] * mean_b[i];
        const double variances = mean_aa[i] + mean_bb[i] - squares;
        const double covariance = mean_ab[i] - product;
        map.values[i] = static_cast<float>((2.0 * product + kC1) * (2.0 * covariance + kC2) /
                                           ((squares + kC1) * (variances + kC2)));
    }
    return map;
}

}  // namespace utsuri
