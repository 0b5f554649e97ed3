// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/scene.h"

#include <span>
#include <vector>

namespace utsuri {

/// An alias table (Walker 1977, built after Vose 1991) over weights >= 0 of which one at least is positive;
/// empty for no weights. Sets `probability` of the lights to weight over sum.
std::vector<interop::LightTableEntry> make_light_table(std::span<const double> weights,
                                                       std::span<interop::LightInfo> lights);

}  // namespace utsuri
