// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace utsuri {
namespace {

using testing::HasSubstr;

template <typename Function>
std::string failure_of(Function&& function) {
    try {
        function();
    } catch (const CheckFailure& failure) {
        return failure.what();
    }
    return {};
}

TEST(Check, TellsExpressionOperandsAndPlace) {
    const int found = 3;
    const std::string text = failure_of([&] { UTSURI_CHECK_EQ(found, 2 + 2); });
    EXPECT_THAT(text, HasSubstr("found == 2 + 2"));
    EXPECT_THAT(text, HasSubstr("(3 vs 4)"));
    EXPECT_THAT(text, HasSubstr("check_test.cpp:"));
}

TEST(Check, PassesExactlyWhereTheRelationHolds) {
    EXPECT_EQ(failure_of([] { UTSURI_CHECK_LT(1, 2); }), "");
    EXPECT_NE(failure_of([] { UTSURI_CHECK_LT(2, 2); }), "");
    EXPECT_EQ(failure_of([] { UTSURI_CHECK_LE(2, 2); }), "");
    EXPECT_NE(failure_of([] { UTSURI_CHECK_LE(3, 2); }), "");
    EXPECT_EQ(failure_of([] { UTSURI_CHECK_EQ(2, 2); }), "");
    EXPECT_EQ(failure_of([] { UTSURI_CHECK(2 > 1); }), "");
    EXPECT_THAT(failure_of([] { UTSURI_CHECK(2 > 3); }), HasSubstr("2 > 3"));
}

TEST(Check, EvaluatesOperandsOnce) {
    int evaluations = 0;
    const auto next = [&] { return ++evaluations; };
    UTSURI_CHECK_LT(0, next());
    EXPECT_EQ(evaluations, 1);
}

}  // namespace
}  // namespace utsuri
