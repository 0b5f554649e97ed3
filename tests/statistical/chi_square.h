// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace utsuri::test {

/// Probability below which a test rejects: 1e-3 for the whole suite, shared by its at most 50 tests
/// (Bonferroni).
inline constexpr double kRejection = 1e-3 / 50.0;

/// Probability that a chi-square variable with `freedom` degrees of freedom exceeds x.
double chi_square_tail(double x, double freedom);

/// Pearson's test: probability of counts as far from the expected ones, or farther, by chance. Cells that
/// expect fewer than five, for which the chi-square law is too coarse, are counted as one.
/// @param expected of the same size and sum as `observed`
double chi_square_p_value(std::span<const double> observed, std::span<const double> expected);

}  // namespace utsuri::test
