// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/changed_bytes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace utsuri {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Bytes = std::vector<std::byte>;

Bytes with_changed(Bytes bytes, std::initializer_list<std::size_t> places) {
    for (const std::size_t place : places)
        bytes[place] ^= std::byte{1};
    return bytes;
}

TEST(ChangedBytes, AreNoneWhereNothingDiffers) {
    EXPECT_THAT(differing_ranges({}, {}), IsEmpty());
    const Bytes bytes(3 * kLeastGap + 1);
    EXPECT_THAT(differing_ranges(bytes, Bytes(bytes)), IsEmpty());
}

TEST(ChangedBytes, ReachFromTheFirstToTheLastThatDiffers) {
    const Bytes bytes(3 * kLeastGap + 1);
    EXPECT_THAT(differing_ranges(bytes, with_changed(bytes, {0})), ElementsAre(ByteRange{0, 1}));
    EXPECT_THAT(differing_ranges(bytes, with_changed(bytes, {10, 14})), ElementsAre(ByteRange{10, 5}));
    EXPECT_THAT(differing_ranges(bytes, with_changed(bytes, {3 * kLeastGap})),
                ElementsAre(ByteRange{3 * kLeastGap, 1}));
}

TEST(ChangedBytes, AreOneRangeUnlessFarApart) {
    const Bytes bytes(4 * kLeastGap);
    // Equal bytes between them: one less than the least gap, and as many.
    EXPECT_THAT(differing_ranges(bytes, with_changed(bytes, {5, 5 + kLeastGap})),
                ElementsAre(ByteRange{5, kLeastGap + 1}));
    EXPECT_THAT(differing_ranges(bytes, with_changed(bytes, {5, 6 + kLeastGap})),
                ElementsAre(ByteRange{5, 1}, ByteRange{6 + kLeastGap, 1}));
}

TEST(ChangedBytes, MakeTheOneOfTheOther) {
    std::mt19937 random(11);
    for (int round = 0; round < 50; ++round) {
        Bytes before(1 + random() % (20 * kLeastGap));
        Bytes after = before;
        for (std::uint32_t i = random() % 20; i > 0; --i)
            after[random() % after.size()] = static_cast<std::byte>(random() % 256);
        std::uint64_t end = 0;
        for (const ByteRange& range : differing_ranges(before, after)) {
            EXPECT_TRUE(end == 0 || range.offset >= end + kLeastGap);
            EXPECT_GT(range.size, 0u);
            end = range.offset + range.size;
            ASSERT_LE(end, before.size());
            std::copy_n(after.begin() + static_cast<std::ptrdiff_t>(range.offset), range.size,
                        before.begin() + static_cast<std::ptrdiff_t>(range.offset));
        }
        EXPECT_EQ(before, after);
    }
}

}  // namespace
}  // namespace utsuri
