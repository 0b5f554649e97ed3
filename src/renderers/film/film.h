// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/buffer.h"
#include "image/image.h"

#include "interop/frame.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace utsuri {

/// Relative standard error of a picture, found from the difference of its two halves (even and odd samples):
/// the root mean square error of the mean over the pixels' mean.
struct NoiseEstimate {
    double mse = 0.0;       ///< of the whole picture, (cd/m2)^2, mean over pixels and channels
    double relative = 0.0;  ///< sqrt(mse) over the mean value; 0 for a black picture
};

/// The sums of samples of a picture, on the device. Held in bands of whole rows, because a picture can be
/// larger than what a kernel may see of one buffer.
class Film {
  public:
    struct Band {
        std::uint32_t first_row;
        std::uint32_t rows;
        Buffer pixels;  ///< interop::FilmPixel
    };

    /// @throws DeviceError if it does not fit
    Film(Device& device, std::uint32_t width, std::uint32_t height, const std::string& name);

    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }
    [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }
    [[nodiscard]] std::uint32_t samples() const { return samples_; }
    void note_samples(std::uint32_t count) { samples_ += count; }
    /// Forgets all samples.
    void clear();

    /// Mean over the samples; black without samples.
    [[nodiscard]] Image resolve() const;
    /// Mean over every other sample, the even ones (0) or the odd ones (1); black without any. The halves are
    /// independent. Of an even number of samples, a half differs from the whole by as much as the whole from
    /// the truth, in the mean square.
    [[nodiscard]] Image resolve_half(std::uint32_t half) const;
    /// Needs an even number of samples, at least 2.
    [[nodiscard]] NoiseEstimate estimate_noise() const;

    /// Device memory of a film, in bytes.
    static std::uint64_t bytes(std::uint32_t width, std::uint32_t height) {
        return std::uint64_t{width} * height * sizeof(interop::FilmPixel);
    }

  private:
    [[nodiscard]] Image mean(const std::function<glm::dvec3(const interop::FilmPixel&)>& sum,
                             std::uint32_t count) const;

    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t samples_ = 0;
    std::vector<Band> bands_;
};

/// Rows of a picture that one buffer of `bytes_per_pixel` may hold, at least 1.
std::uint32_t rows_per_band(const Device& device, std::uint32_t width, std::size_t bytes_per_pixel);

}  // namespace utsuri
