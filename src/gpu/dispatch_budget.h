// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace utsuri {

/// Decides how much work goes into the next dispatch, so that each takes about `seconds`: well under the time
/// after which drivers reset a device (2 s on Windows), and short enough for small pictures to show progress
/// and heed Ctrl-C between dispatches. A sample of a large picture takes many, and is not left half done.
class DispatchBudget {
  public:
    explicit DispatchBudget(double seconds = 0.1) : seconds_(seconds) {}

    /// Units of work for the next dispatch, at least 1. Starts small and grows by at most 8 times a step.
    [[nodiscard]] std::uint64_t next_units() const { return units_; }
    /// Tells what a dispatch of `units` took on the device.
    void record(std::uint64_t units, double device_seconds);

  private:
    double seconds_;
    std::uint64_t units_ = 64;
};

}  // namespace utsuri
