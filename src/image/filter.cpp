// SPDX-License-Identifier: Apache-2.0
#include "image/filter.h"

#include "base/check.h"

#include <array>

namespace utsuri {
namespace {

/// A block of sums stays in registers over all taps, and its fixed length lets the compiler vectorise it.
constexpr std::size_t kBlock = 16;

/// Sums `kernel` over values that lie `step` apart, for every x of one row.
template <typename T>
void filter_row(const T* in, std::size_t step, const Kernel<T>& kernel, T* out, std::size_t width,
                bool accumulate) {
    std::size_t x = 0;
    for (; x + kBlock <= width; x += kBlock) {
        std::array<T, kBlock> sums{};
        const T* source = in + x;
        for (const T weight : kernel) {
            for (std::size_t i = 0; i < kBlock; ++i)
                sums[i] += weight * source[i];
            source += step;
        }
        for (std::size_t i = 0; i < kBlock; ++i)
            out[x + i] = accumulate ? out[x + i] + sums[i] : sums[i];
    }
    for (; x < width; ++x) {
        T sum{};
        const T* source = in + x;
        for (const T weight : kernel) {
            sum += weight * *source;
            source += step;
        }
        out[x] = accumulate ? out[x] + sum : sum;
    }
}

}  // namespace

template <typename T>
Kernel<T> sample_kernel(int radius, const std::function<double(double)>& weight) {
    Kernel<T> kernel;
    for (int offset = -radius; offset <= radius; ++offset) {
        kernel.push_back(static_cast<T>(weight(static_cast<double>(offset))));
    }
    return kernel;
}

template <typename T>
void normalise_by_sign(Kernel<T>& kernel) {
    double positive = 0.0;
    double negative = 0.0;
    for (const T weight : kernel)
        (weight > T{} ? positive : negative) += static_cast<double>(weight);
    for (T& weight : kernel) {
        if (weight != T{})
            weight = static_cast<T>(static_cast<double>(weight) / (weight > T{} ? positive : -negative));
    }
}

template <typename T>
void filter_rows(const Raster<const T>& in, const Kernel<T>& kernel, const Raster<T>& out) {
    UTSURI_CHECK_EQ(in.width, out.width + kernel.size() - 1);
    UTSURI_CHECK_EQ(in.height, out.height);
    for (std::size_t y = 0; y < out.height; ++y) {
        filter_row(in.data + y * in.stride, 1, kernel, out.data + y * out.stride, out.width, false);
    }
}

template <typename T>
void filter_columns(const Raster<const T>& in, const Kernel<T>& kernel, const Raster<T>& out,
                    bool accumulate) {
    UTSURI_CHECK_EQ(in.width, out.width);
    UTSURI_CHECK_EQ(in.height, out.height + kernel.size() - 1);
    for (std::size_t y = 0; y < out.height; ++y) {
        filter_row(in.data + y * in.stride, in.stride, kernel, out.data + y * out.stride, out.width,
                   accumulate);
    }
}

template Kernel<float> sample_kernel(int, const std::function<double(double)>&);
template Kernel<double> sample_kernel(int, const std::function<double(double)>&);
template void normalise_by_sign(Kernel<float>&);
template void normalise_by_sign(Kernel<double>&);
template void filter_rows(const Raster<const float>&, const Kernel<float>&, const Raster<float>&);
template void filter_rows(const Raster<const double>&, const Kernel<double>&, const Raster<double>&);
template void filter_columns(const Raster<const float>&, const Kernel<float>&, const Raster<float>&, bool);
template void filter_columns(const Raster<const double>&, const Kernel<double>&, const Raster<double>&, bool);

}  // namespace utsuri
