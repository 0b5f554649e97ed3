// SPDX-License-Identifier: Apache-2.0
#include "base/same_bits.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace utsuri {
namespace {

struct Record {
    float value = 0.0f;
    int number = 0;
};

TEST(SameBits, HoldsForCopies) {
    const Record record{.value = 1.5f, .number = 3};
    const Record copy = record;
    EXPECT_TRUE(same_bits(record, copy));
    EXPECT_FALSE(same_bits(record, Record{.value = 1.5f, .number = 4}));
}

TEST(SameBits, HoldsForListsOfTheSameRecords) {
    const std::vector<Record> none;
    const std::vector<Record> two{{.value = 1.5f, .number = 3}, {.value = 2.5f, .number = 4}};
    EXPECT_TRUE(same_bits(none, none));
    EXPECT_TRUE(same_bits(two, std::vector<Record>(two)));
    EXPECT_FALSE(same_bits(two, none));
    EXPECT_FALSE(same_bits(two, std::vector<Record>{two.front(), {.value = 2.5f, .number = 5}}));
}

TEST(SameBits, TellsSignsOfZeros) {
    EXPECT_FALSE(same_bits(Record{.value = 0.0f}, Record{.value = -0.0f}));
}

TEST(SameBits, HoldsForANaNAndItself) {
    const Record record{.value = std::numeric_limits<float>::quiet_NaN()};
    EXPECT_TRUE(same_bits(record, record));
}

}  // namespace
}  // namespace utsuri
