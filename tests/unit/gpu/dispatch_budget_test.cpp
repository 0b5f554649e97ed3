// SPDX-License-Identifier: Apache-2.0
#include "gpu/dispatch_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace utsuri {
namespace {

/// Runs `dispatches` on a device that takes `seconds_per_unit`, and gives the units it ends with.
std::uint64_t settle(DispatchBudget& budget, double seconds_per_unit, int dispatches) {
    for (int i = 0; i < dispatches; ++i) {
        const std::uint64_t units = budget.next_units();
        budget.record(units, static_cast<double>(units) * seconds_per_unit);
    }
    return budget.next_units();
}

TEST(DispatchBudget, StartsSmall) {
    // A software driver works on a tile in some 10 ms: the first dispatch must not take seconds.
    const std::uint64_t first = DispatchBudget().next_units();
    EXPECT_GE(first, 1u);
    EXPECT_LE(first, 100u);
}

TEST(DispatchBudget, GrowsByAtMostEight) {
    DispatchBudget budget(0.1);
    for (const double seconds : {0.0, 1e-12, 1e-6, 1e-3}) {
        const std::uint64_t before = budget.next_units();
        budget.record(before, seconds);
        EXPECT_EQ(budget.next_units(), 8 * before) << seconds;
    }
}

TEST(DispatchBudget, SettlesWhereADispatchTakesItsTime) {
    for (const double seconds_per_unit : {1e-8, 1e-5, 1e-3}) {
        DispatchBudget budget(0.1);
        const double settled = static_cast<double>(settle(budget, seconds_per_unit, 20));
        // Rounded down to whole units.
        EXPECT_LE(settled * seconds_per_unit, 0.1 * (1.0 + 1e-12));
        EXPECT_GE((settled + 1.0) * seconds_per_unit, 0.1 * (1.0 - 1e-12));
    }
}

TEST(DispatchBudget, ShrinksWhereDispatchesTakeTooLong) {
    DispatchBudget budget(0.1);
    const std::uint64_t before = settle(budget, 1e-6, 20);
    budget.record(before, 0.4);
    EXPECT_EQ(budget.next_units(), before / 4);
    const std::uint64_t less = budget.next_units();
    budget.record(less, 1000.0);
    EXPECT_EQ(budget.next_units(), less / 8);
}

TEST(DispatchBudget, NeverStops) {
    DispatchBudget budget(0.1);
    EXPECT_EQ(settle(budget, 1000.0, 50), 1u);
    budget.record(1, std::numeric_limits<double>::infinity());
    EXPECT_EQ(budget.next_units(), 1u);
}

TEST(DispatchBudget, StaysFiniteOnADeviceWithoutAClock) {
    DispatchBudget budget(0.1);
    const std::uint64_t units = settle(budget, 0.0, 100);
    EXPECT_LE(units, std::uint64_t{1} << 40);
    EXPECT_GT(units, std::uint64_t{1} << 30);
}

TEST(DispatchBudget, ScalesWhatWasRunNotWhatWasProposed) {
    // The last dispatch of a picture is often smaller than proposed.
    DispatchBudget budget(0.1);
    budget.record(10, 0.05);
    EXPECT_EQ(budget.next_units(), 20u);
}

}  // namespace
}  // namespace utsuri
