// SPDX-License-Identifier: Apache-2.0
#include "gpu/dispatch_budget.h"

#include <algorithm>
#include <cmath>

namespace utsuri {

void DispatchBudget::record(std::uint64_t units, double device_seconds) {
    constexpr double kLargestStep = 8.0;
    const double wanted_ratio = device_seconds > 0.0 ? seconds_ / device_seconds : kLargestStep;
    const double next =
        static_cast<double>(units) * std::clamp(wanted_ratio, 1.0 / kLargestStep, kLargestStep);
    // 2^40 units is beyond any picture; the bound keeps the product of repeated growth finite.
    units_ = static_cast<std::uint64_t>(std::clamp(std::floor(next), 1.0, std::ldexp(1.0, 40)));
}

}  // namespace utsuri
