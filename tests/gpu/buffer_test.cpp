// SPDX-License-Identifier: Apache-2.0
#include "gpu/buffer.h"

#include "support/test_device.h"

#include "base/check.h"
#include "base/error.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numeric>

namespace utsuri {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

using BufferOnDevice = DeviceTest;

std::vector<std::uint32_t> numbers(std::size_t count) {
    std::vector<std::uint32_t> result(count);
    std::iota(result.begin(), result.end(), 1u);
    return result;
}

TEST_F(BufferOnDevice, GivesBackWhatWasUploaded) {
    // 40 MiB take more than one piece of the staging copy on a device that has one.
    for (const std::size_t count : {std::size_t{1}, std::size_t{1000}, std::size_t{10} << 20}) {
        const std::vector<std::uint32_t> expected = numbers(count);
        const Buffer buffer = make_buffer<std::uint32_t>(device(), expected, "round trip");
        EXPECT_EQ(buffer.size(), 4 * count);
        EXPECT_EQ(buffer.download_records<std::uint32_t>(count), expected);
    }
}

TEST_F(BufferOnDevice, UploadsAndDownloadsAtAnOffset) {
    Buffer buffer = make_buffer<std::uint32_t>(device(), numbers(100), "offsets");
    const std::vector<std::uint32_t> patch = {7000, 8000};
    buffer.upload(std::as_bytes(std::span(patch)), 40);
    std::vector<std::uint32_t> expected = numbers(100);
    expected[10] = 7000;
    expected[11] = 8000;
    EXPECT_EQ(buffer.download_records<std::uint32_t>(100), expected);
    std::vector<std::uint32_t> part(3);
    buffer.download(std::as_writable_bytes(std::span(part)), 36);
    EXPECT_EQ(part, (std::vector<std::uint32_t>{10, 7000, 8000}));
}

TEST_F(BufferOnDevice, UploadsManyRangesAtOnce) {
    // 100 MiB in all, more than the staging copy takes at once, in ranges that do not divide its pieces.
    constexpr std::size_t kCount = std::size_t{26} << 20;
    constexpr std::size_t kRange = 1'000'003;
    std::vector<std::uint32_t> expected = numbers(kCount);
    Buffer buffer = make_buffer<std::uint32_t>(device(), expected, "ranges");
    std::vector<std::uint32_t> patch(kCount);
    std::iota(patch.begin(), patch.end(), 7000u);
    std::vector<Upload> uploads;
    for (std::size_t first = 0; first < kCount; first += kRange) {
        const std::size_t count = std::min(kRange - 1, kCount - first);
        uploads.push_back({4 * first, std::as_bytes(std::span(patch).subspan(first, count))});
        std::copy_n(patch.begin() + static_cast<std::ptrdiff_t>(first), count,
                    expected.begin() + static_cast<std::ptrdiff_t>(first));
    }
    buffer.upload(uploads);
    EXPECT_TRUE(buffer.download_records<std::uint32_t>(kCount) == expected);
}

TEST_F(BufferOnDevice, CountsWhatItUploads) {
    const std::uint64_t before = device().uploaded_bytes();
    Buffer buffer = make_buffer<std::uint32_t>(device(), numbers(100), "counted");
    EXPECT_EQ(device().uploaded_bytes() - before, 400u);
    const std::vector<std::uint32_t> patch = {1, 2, 3};
    const auto bytes = std::as_bytes(std::span(patch));
    buffer.upload(std::vector<Upload>{{0, bytes}, {40, {}}, {80, bytes.first(4)}});
    EXPECT_EQ(device().uploaded_bytes() - before, 416u);
    buffer.upload(std::vector<Upload>());
    EXPECT_EQ(device().uploaded_bytes() - before, 416u);
}

TEST_F(BufferOnDevice, FillsWithZero) {
    Buffer buffer = make_buffer<std::uint32_t>(device(), numbers(1001), "zeroes");
    buffer.fill_with_zero();
    EXPECT_THAT(buffer.download_records<std::uint32_t>(1001), Each(0u));
}

TEST_F(BufferOnDevice, OfNothingIsOneZeroedRecord) {
    const Buffer buffer = make_buffer<std::uint64_t>(device(), {}, "empty");
    EXPECT_EQ(buffer.size(), sizeof(std::uint64_t));
    EXPECT_THAT(buffer.download_records<std::uint64_t>(1), Each(0u));
}

TEST_F(BufferOnDevice, RefusesToReachBeyondItsEnd) {
    Buffer buffer = make_buffer<std::uint32_t>(device(), numbers(4), "short");
    const std::vector<std::uint32_t> two = {1, 2};
    EXPECT_THROW(buffer.upload(std::as_bytes(std::span(two)), 12), CheckFailure);
    EXPECT_THROW(static_cast<void>(buffer.download_records<std::uint32_t>(5)), CheckFailure);
    EXPECT_THROW(Buffer(device(), 0, "nothing"), CheckFailure);
}

TEST_F(BufferOnDevice, TellsThatItIsTooLarge) {
    const std::uint64_t limit = device().summary().storage_range_bytes;
    try {
        const Buffer buffer(device(), limit + 1, "all the world's triangles");
        FAIL() << "a buffer of " << limit + 1 << " bytes";
    } catch (const DeviceError& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::device);
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("all the world's triangles"), HasSubstr(fmt::format("{}", limit + 1)),
                          HasSubstr(fmt::format("at most {}", limit))));
    }
}

TEST_F(BufferOnDevice, AccountsForItsMemory) {
    const MemoryUsage before = device().memory();
    device().reset_peak_memory();
    {
        Buffer first(device(), 1000, "first");
        const std::uint64_t one = device().memory().current - before.current;
        EXPECT_GE(one, 1000u);
        Buffer moved = std::move(first);
        EXPECT_EQ(device().memory().current - before.current, one) << "moving takes nothing";
        Buffer second(device(), 1 << 20, "second");
        const std::uint64_t both = device().memory().current - before.current;
        EXPECT_GE(both, one + (1u << 20));
        second = std::move(moved);
        EXPECT_EQ(device().memory().current - before.current, one) << "what is assigned over is released";
        EXPECT_EQ(device().memory().peak - before.current, both);
    }
    EXPECT_EQ(device().memory().current, before.current);
    device().reset_peak_memory();
    EXPECT_EQ(device().memory().peak, before.current);
}

TEST_F(BufferOnDevice, AccountsForNothingWhereItCouldNotBeHad) {
    const std::uint64_t before = device().memory().current;
    EXPECT_THROW(Buffer(device(), device().summary().storage_range_bytes + 1, "too large"), DeviceError);
    EXPECT_EQ(device().memory().current, before);
}

TEST_F(BufferOnDevice, KeepsItsContentWhenMoved) {
    Buffer a = make_buffer<std::uint32_t>(device(), numbers(10), "a");
    Buffer b = make_buffer<std::uint32_t>(device(), numbers(2), "b");
    b = std::move(a);
    EXPECT_EQ(b.name(), "a");
    EXPECT_EQ(b.download_records<std::uint32_t>(10), numbers(10));
}

}  // namespace
}  // namespace utsuri
