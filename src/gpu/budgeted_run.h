// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/device.h"
#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace utsuri {

/// Runs a kernel over `count` invocations in dispatches that fit the budget, each submitted and waited for.
/// How the work is cut changes no result.
/// @param operation what the work is, for messages
/// @param push its `begin` and `end` tell the kernel which invocations a dispatch is for: [begin, end)
/// @param budget in units of invocations
/// @returns seconds on the device
/// @throws DeviceError
template <typename Push>
double run_in_budget(Device& device, std::string_view operation, const Kernel& kernel, const BindingSet& set,
                     Push push, std::uint32_t count, DispatchBudget& budget) {
    constexpr std::uint64_t kMost = std::uint64_t{kMaxGroups} * interop::WORKGROUP_SIZE;
    double sum = 0.0;
    for (push.begin = 0; push.begin < count; push.begin = push.end) {
        const auto fitting = static_cast<std::uint32_t>(
            std::clamp<std::uint64_t>(budget.next_units(), interop::WORKGROUP_SIZE, kMost));
        push.end = push.begin + std::min(count - push.begin, fitting);
        const double seconds = device.run(operation, [&](const vk::raii::CommandBuffer& commands) {
            kernel.dispatch(commands, set, push, group_count(push.end - push.begin));
        });
        budget.record(push.end - push.begin, seconds);
        sum += seconds;
    }
    return sum;
}

}  // namespace utsuri
