// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/scene.h"

#include <span>

namespace utsuri {

/// Makes lights an alias table (Walker 1977, built after Vose 1991) by weights >= 0 of which one at least is
/// positive, unless there are none: sets their `threshold` and `alias`, and `probability` to weight over sum.
void make_light_table(std::span<const double> weights, std::span<interop::LightInfo> lights);

}  // namespace utsuri
