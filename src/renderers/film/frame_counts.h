// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace utsuri {

/// Totals over dispatches.
struct FrameCounts {
    std::uint64_t rays = 0;       ///< closest-hit and any-hit queries
    std::uint64_t nonfinite = 0;  ///< samples that were not finite and were left out
    std::uint64_t lookups = 0;    ///< specular directions resolved
    std::uint64_t traced = 0;     ///< of those, by following a ray
    std::uint64_t truncated = 0;  ///< specular chains cut at the depth bound
    double gpu_seconds = 0.0;     ///< by the device's clock
};

/// Adds b to a.
void accumulate(FrameCounts& a, const FrameCounts& b);

}  // namespace utsuri
