// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace utsuri {

/// Odd number of weights; the middle one belongs to the pixel itself.
template <typename T>
using Kernel = std::vector<T>;

/// A kernel of 2 * radius + 1 weights, `weight(offset in pixels)` each.
template <typename T>
[[nodiscard]] Kernel<T> sample_kernel(int radius, const std::function<double(double)>& weight);

/// Scales the positive weights to the sum one and the negative ones to the sum minus one; a sign that is
/// absent stays absent.
template <typename T>
void normalise_by_sign(Kernel<T>& kernel);

/// A rectangle inside an array of rows; the owner of the values outlives it.
template <typename T>
struct Raster {
    T* data = nullptr;
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t stride = 0;  ///< values from one row to the next, >= width

    /// The part of `w` columns and `h` rows whose top left corner is (x, y).
    [[nodiscard]] Raster part(std::size_t x, std::size_t y, std::size_t w, std::size_t h) const {
        return {data + y * stride + x, w, h, stride};
    }
};

/// out(x, y) = sum over k of kernel[k] * in(x + k, y): a correlation along the rows. `in` is wider than `out`
/// by kernel.size() - 1 and equally high; they do not overlap.
template <typename T>
void filter_rows(const Raster<const T>& in, const Kernel<T>& kernel, const Raster<T>& out);

/// The same along the columns; `in` is higher than `out` by kernel.size() - 1. With `accumulate` the sum is
/// added to what `out` holds.
template <typename T>
void filter_columns(const Raster<const T>& in, const Kernel<T>& kernel, const Raster<T>& out,
                    bool accumulate = false);

}  // namespace utsuri
