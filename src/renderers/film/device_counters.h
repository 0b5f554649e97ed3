// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/frame_counts.h"

#include "gpu/buffer.h"

#include <string>
#include <string_view>

namespace utsuri {

/// Counters on the device that kernels add to: shaders/kernels/film/counters.glsl. They have 64 bits, which
/// no render passes.
class DeviceCounters {
  public:
    /// All counters are 0.
    /// @param name shown in messages and debuggers
    DeviceCounters(Device& device, const std::string& name);

    /// What BINDING_COUNTERS is bound to: interop::Counters twice, the totals modulo 2^32 and their carries.
    [[nodiscard]] Buffer& buffer() { return buffer_; }
    void clear() { buffer_.fill_with_zero(); }

    /// What was counted since clear(); the time on the device is left out.
    /// @param operation what was done, for the message
    /// @param workers what each invocation stands for, for the message, such as "pixels"
    /// @param remedy what would give their loops less to do, for the message, such as "a smaller --depth"
    /// @throws DeviceError if the driver ended loops early: Mesa's software driver does after 65535
    /// iterations
    [[nodiscard]] FrameCounts read(std::string_view operation, std::string_view workers,
                                   std::string_view remedy) const;

  private:
    const Device& device_;
    Buffer buffer_;
};

}  // namespace utsuri
