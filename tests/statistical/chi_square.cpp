// SPDX-License-Identifier: Apache-2.0
#include "chi_square.h"

#include <cmath>

namespace utsuri::test {
namespace {

constexpr double kFewestExpected = 5.0;
constexpr int kMostTerms = 10000;
constexpr double kPrecision = 1e-15;

/// Regularised lower incomplete gamma function by its power series, which is quick for x < a + 1.
double lower_gamma_series(double a, double x) {
    double term = 1.0 / a;
    double sum = term;
    for (int i = 1; i < kMostTerms && term > sum * kPrecision; ++i) {
        term *= x / (a + i);
        sum += term;
    }
    return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// The upper one by Legendre's continued fraction, evaluated from its end; quick for x > a + 1.
double upper_gamma_fraction(double a, double x) {
    double tail = 0.0;
    for (int i = 500; i >= 1; --i)
        tail = i * (i - a) / (x + 2.0 * i + 1.0 - a - tail);
    return std::exp(a * std::log(x) - x - std::lgamma(a)) / (x + 1.0 - a - tail);
}

}  // namespace

double chi_square_tail(double x, double freedom) {
    if (x <= 0.0) return 1.0;
    const double a = 0.5 * freedom;
    const double half = 0.5 * x;
    return half < a + 1.0 ? 1.0 - lower_gamma_series(a, half) : upper_gamma_fraction(a, half);
}

double chi_square_p_value(std::span<const double> observed, std::span<const double> expected) {
    double statistic = 0.0;
    double freedom = -1.0;
    double rare_observed = 0.0;
    double rare_expected = 0.0;
    const auto add = [&](double seen, double wanted) {
        statistic += (seen - wanted) * (seen - wanted) / wanted;
        freedom += 1.0;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] < kFewestExpected) {
            rare_observed += observed[i];
            rare_expected += expected[i];
        } else {
            add(observed[i], expected[i]);
        }
    }
    if (rare_expected > 0.0) {
        add(rare_observed, rare_expected);
    } else if (rare_observed > 0.0) {
        return 0.0;
    }
    return freedom > 0.0 ? chi_square_tail(statistic, freedom) : 1.0;
}

}  // namespace utsuri::test
