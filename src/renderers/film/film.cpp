// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/film.h"

#include "base/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace utsuri {
namespace {

/// A band larger than this gains nothing and takes long to read back.
constexpr std::uint64_t kLargestBand = 64ull << 20;

glm::dvec3 total(const interop::FilmSum& half) {
    return glm::dvec3(half.sum) - glm::dvec3(half.compensation);
}

}  // namespace

std::uint32_t rows_per_band(const Device& device, std::uint32_t width, std::size_t bytes_per_pixel) {
    const std::uint64_t limit = std::min(kLargestBand, device.summary().storage_range_bytes);
    return static_cast<std::uint32_t>(
        std::max<std::uint64_t>(1, limit / (std::uint64_t{width} * bytes_per_pixel)));
}

Film::Film(Device& device, std::uint32_t width, std::uint32_t height, const std::string& name)
    : width_(width), height_(height) {
    UTSURI_CHECK_LT(0u, width);
    UTSURI_CHECK_LT(0u, height);
    const std::uint32_t rows = rows_per_band(device, width, sizeof(interop::FilmPixel));
    for (std::uint32_t first = 0; first < height; first += rows) {
        const std::uint32_t count = std::min(rows, height - first);
        bands_.push_back(
            {first, count, Buffer(device, bytes(width, count), fmt::format("{}, row {}", name, first))});
    }
    clear();
}

void Film::clear() {
    for (Band& band : bands_)
        band.pixels.fill_with_zero();
    samples_ = 0;
}

Image Film::resolve() const {
    return mean(
        [](const interop::FilmPixel& pixel) { return total(pixel.halves[0]) + total(pixel.halves[1]); },
        samples_);
}

Image Film::resolve_half(std::uint32_t half) const {
    UTSURI_CHECK_LT(half, 2u);
    return mean([half](const interop::FilmPixel& pixel) { return total(pixel.halves[half]); },
                (samples_ + 1 - half) / 2);
}

Image Film::mean(const std::function<glm::dvec3(const interop::FilmPixel&)>& sum, std::uint32_t count) const {
    Image image(width_, height_);
    if (count == 0) return image;
    std::size_t at = 0;
    for (const Band& band : bands_) {
        const auto pixels = band.pixels.download_records<interop::FilmPixel>(std::size_t{width_} * band.rows);
        for (const interop::FilmPixel& pixel : pixels)
            image.pixels[at++] = glm::vec3(sum(pixel) / static_cast<double>(count));
    }
    return image;
}

NoiseEstimate Film::estimate_noise() const {
    UTSURI_CHECK(samples_ >= 2 && samples_ % 2 == 0);
    const double half = 0.5 * static_cast<double>(samples_);
    double squares = 0.0;
    double sum = 0.0;
    for (const Band& band : bands_) {
        const auto pixels = band.pixels.download_records<interop::FilmPixel>(std::size_t{width_} * band.rows);
        for (const interop::FilmPixel& pixel : pixels) {
            const glm::dvec3 even = total(pixel.halves[0]) / half;
            const glm::dvec3 odd = total(pixel.halves[1]) / half;
            const glm::dvec3 difference = even - odd;
            squares +=
                difference.x * difference.x + difference.y * difference.y + difference.z * difference.z;
            sum += 0.5 * (even.x + even.y + even.z + odd.x + odd.y + odd.z);
        }
    }
    const double values = 3.0 * static_cast<double>(width_) * static_cast<double>(height_);
    NoiseEstimate estimate;
    // The variance of a half is half the mean squared difference; the mean of two halves has half of that
    // again.
    estimate.mse = 0.25 * squares / values;
    estimate.relative = sum > 0.0 ? std::sqrt(estimate.mse) / (sum / values) : 0.0;
    return estimate;
}

}  // namespace utsuri
