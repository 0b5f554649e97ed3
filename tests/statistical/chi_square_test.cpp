// SPDX-License-Identifier: Apache-2.0
#include "chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace utsuri::test {
namespace {

// Two degrees of freedom: exp(-x / 2). One: erfc(sqrt(x / 2)). Ten: exp(-h) (1 + h + h^2/2 + h^3/6 + h^4/24),
// h = x / 2.
TEST(ChiSquare, TailHasItsClosedForms) {
    for (const double x : {0.1, 1.0, 3.0, 10.0, 40.0}) {
        const double h = 0.5 * x;
        const double ten = std::exp(-h) * (1.0 + h * (1.0 + h / 2.0 * (1.0 + h / 3.0 * (1.0 + h / 4.0))));
        EXPECT_NEAR(chi_square_tail(x, 2.0), std::exp(-h), 1e-12 + 1e-10 * std::exp(-h));
        EXPECT_NEAR(chi_square_tail(x, 1.0), std::erfc(std::sqrt(h)), 1e-12);
        EXPECT_NEAR(chi_square_tail(x, 10.0), ten, 1e-12);
    }
}

// Statistic (60 - 50)^2 / 50 + (40 - 50)^2 / 50 = 4 with one degree of freedom.
TEST(ChiSquare, PearsonsStatistic) {
    const std::vector<double> observed = {60, 40};
    const std::vector<double> expected = {50, 50};
    EXPECT_NEAR(chi_square_p_value(observed, expected), std::erfc(std::sqrt(2.0)), 1e-12);
}

// The rare cells 4, 1, 3, seen as 3, 2, 4, make one cell of 8, seen as 9.
TEST(ChiSquare, RareCellsCountAsOne) {
    const std::vector<double> observed = {91, 3, 2, 4};
    const std::vector<double> expected = {92, 4, 1, 3};
    const double statistic = 1.0 / 92.0 + 1.0 / 8.0;
    EXPECT_NEAR(chi_square_p_value(observed, expected), std::erfc(std::sqrt(statistic / 2.0)), 1e-12);
}

TEST(ChiSquare, AnImpossibleCellIsRejected) {
    const std::vector<double> observed = {50, 49, 1};
    const std::vector<double> expected = {50, 50, 0};
    EXPECT_EQ(chi_square_p_value(observed, expected), 0.0);
}

}  // namespace
}  // namespace utsuri::test
