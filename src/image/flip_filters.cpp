// SPDX-License-Identifier: Apache-2.0
#include "image/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace utsuri {
namespace {

/// a * sqrt(pi / b) * exp(-pi^2 x^2 / b), x in degrees: table 1 of the 2020 paper.
struct CsfTerm {
    double a;
    double b;
};
constexpr CsfTerm kAchromatic{1.0, 0.0047};
constexpr CsfTerm kRedGreen{1.0, 0.0053};
constexpr CsfTerm kBlueYellowWide{34.1, 0.04};
constexpr CsfTerm kBlueYellowNarrow{13.5, 0.025};

/// The kernels reach three deviations of the widest Gaussian.
constexpr double kReach = 3.0;
/// Outer taps below this fraction of the middle one are left out: their sum moves no 8-bit code value.
constexpr double kNegligible = 1e-7;
/// Width of an edge that the feature detectors find, in degrees.
constexpr double kFeatureWidth = 0.082;

constexpr double kPi = std::numbers::pi;

Kernel<double> sample_csf(const CsfTerm& term, int radius, double pixels_per_degree) {
    const double scale = kPi / pixels_per_degree;
    const auto weight = [&](double offset) { return std::exp(-scale * scale * offset * offset / term.b); };
    while (radius > 1 && weight(radius) < kNegligible)
        --radius;
    return sample_kernel<double>(radius, weight);
}

double sum(const Kernel<double>& kernel) {
    double total = 0.0;
    for (const double weight : kernel)
        total += weight;
    return total;
}

/// The unnormalised two-dimensional sum of a term.
double mass(const CsfTerm& term, const Kernel<double>& kernel) {
    return term.a * std::sqrt(kPi / term.b) * sum(kernel) * sum(kernel);
}

CsfGaussian make_gaussian(const Kernel<double>& kernel, double share) {
    CsfGaussian gaussian;
    const double total = sum(kernel);
    for (const double weight : kernel) {
        gaussian.along_rows.push_back(static_cast<float>(weight / total));
        gaussian.along_columns.push_back(static_cast<float>(share * weight / total));
    }
    return gaussian;
}

int reach(const Kernel<float>& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

}  // namespace

FlipFilters::FlipFilters(double pixels_per_degree) {
    const double widest = std::sqrt(kBlueYellowWide.b / (2.0 * kPi * kPi)) * pixels_per_degree;
    const int csf_radius = static_cast<int>(std::ceil(kReach * widest));
    achromatic = make_gaussian(sample_csf(kAchromatic, csf_radius, pixels_per_degree), 1.0);
    red_green = make_gaussian(sample_csf(kRedGreen, csf_radius, pixels_per_degree), 1.0);
    const Kernel<double> wide = sample_csf(kBlueYellowWide, csf_radius, pixels_per_degree);
    const Kernel<double> narrow = sample_csf(kBlueYellowNarrow, csf_radius, pixels_per_degree);
    const double share =
        mass(kBlueYellowWide, wide) / (mass(kBlueYellowWide, wide) + mass(kBlueYellowNarrow, narrow));
    blue_yellow_wide = make_gaussian(wide, share);
    blue_yellow_narrow = make_gaussian(narrow, 1.0 - share);

    const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;
    const int feature_radius = static_cast<int>(std::ceil(kReach * deviation));
    const auto gaussian = [deviation](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
    smooth = sample_kernel<float>(feature_radius, gaussian);
    edge = sample_kernel<float>(feature_radius, [&](double x) { return -x * gaussian(x); });
    point = sample_kernel<float>(
        feature_radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); });
    for (Kernel<float>* kernel : {&smooth, &edge, &point})
        normalise_by_sign(*kernel);
    radius = std::max({reach(blue_yellow_wide.along_rows), reach(achromatic.along_rows), feature_radius});
}

}  // namespace utsuri
