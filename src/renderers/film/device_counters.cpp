// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/device_counters.h"

#include "base/error.h"

#include "interop/frame.h"

#include <fmt/format.h>

#include <cstdint>

namespace utsuri {

DeviceCounters::DeviceCounters(Device& device, const std::string& name)
    : device_(device), buffer_(device, 2 * sizeof(interop::Counters), name) {
    clear();
}

FrameCounts DeviceCounters::read(std::string_view operation, std::string_view workers,
                                 std::string_view remedy) const {
    const auto counters = buffer_.download_records<interop::Counters>(2);
    const auto total = [&](std::uint32_t interop::Counters::*counter) {
        return (std::uint64_t{counters[1].*counter} << 32) + counters[0].*counter;
    };
    if (const std::uint64_t incomplete = total(&interop::Counters::incomplete); incomplete > 0) {
        throw DeviceError(
            operation, device_.summary().name,
            fmt::format("the driver ended the loops of {} {} early; use {}", incomplete, workers, remedy));
    }
    FrameCounts counts;
    counts.rays = total(&interop::Counters::rays);
    counts.nonfinite = total(&interop::Counters::nonfinite);
    counts.lookups = total(&interop::Counters::lookups);
    counts.traced = total(&interop::Counters::traced);
    counts.truncated = total(&interop::Counters::truncated);
    return counts;
}

}  // namespace utsuri
